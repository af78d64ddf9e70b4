#include "mrpt_ext/report/run_csv.h"

#include <algorithm>

#include "mrpt_ext/report/csv_field.h"

namespace mrpt_ext
{
namespace
{
/// A trajectory with the estimate of it that is not written yet.
struct Column
{
  explicit Column(const MethodTrajectory& trajectory) : method(&trajectory), next(trajectory.points.begin()) {}
  [[nodiscard]] bool atEnd() const { return next == method->points.end(); }

  const MethodTrajectory* method;
  DiskBackedSequence<PoseEstimate>::const_iterator next;
};

std::string positionFields(double x, double y) { return lengthField(x) + ',' + lengthField(y); }

std::string covarianceFields(const Eigen::Ref<const Matrix2d>& P)
{
  return covarianceField(P(0, 0)) + ',' + covarianceField(P(0, 1)) + ',' + covarianceField(P(1, 1));
}

std::string stepText(const MethodTrajectory& method, const PoseEstimate& p)
{
  const Matrix3d& P = p.pose.covariance;
  return timeField(p.time) + ',' + textField(method.name) + ',' + positionFields(p.pose.mean.x, p.pose.mean.y) + ',' +
         (p.heading_known ? angleField(p.pose.mean.phi) : "") + ',' + covarianceFields(P.topLeftCorner<2, 2>()) + ',' +
         (p.heading_known ? covarianceField(P(2, 2)) : "") + ',' + std::to_string(p.modes) + ',' +
         shareField(p.best_weight) + ',' + (p.effective_samples ? shareField(*p.effective_samples) : "") + ',' +
         toString(p.verdict) + '\n';
}
}  // namespace

void stepsCsv(const RunRecord& record, const TextSink& write)
{
  write("t,method,x,y,phi_deg,cxx,cxy,cyy,cpp,modes,w_best,ess,verdict\n");
  std::vector<Column> columns(record.methods.begin(), record.methods.end());
  const auto isEarlier = [](const Column& a, const Column& b)
  { return !a.atEnd() && (b.atEnd() || a.next->time < b.next->time); };
  while (!columns.empty())
  {
    Column& first = *std::min_element(columns.begin(), columns.end(), isEarlier);
    if (first.atEnd()) return;
    write(stepText(*first.method, *first.next));
    ++first.next;
  }
}

void hypothesesCsv(const DiskBackedSequence<HypothesisRow>& hypotheses, const TextSink& write)
{
  write("t,rank,x,y,phi_deg,weight,source\n");
  for (const HypothesisRow& row : hypotheses)
    write(timeField(row.time) + ',' + std::to_string(row.rank) + ',' + positionFields(row.pose.x, row.pose.y) + ',' +
          angleField(row.pose.phi) + ',' + shareField(row.weight) + ',' + textField(row.source) + '\n');
}

void objectsCsv(const DiskBackedSequence<ObjectRow>& objects, const TextSink& write)
{
  write("t,label,x,y,cxx,cxy,cyy,x_robot,y_robot\n");
  for (const ObjectRow& row : objects)
    write(timeField(row.time) + ',' + textField(row.label) + ',' + positionFields(row.position.x(), row.position.y()) +
          ',' + covarianceFields(row.covariance) + ',' +
          positionFields(row.position_robot.x(), row.position_robot.y()) + '\n');
}

void biasesCsv(const DiskBackedSequence<BiasRow>& biases, const TextSink& write)
{
  write("t,bias,mean,std\n");
  for (const BiasRow& row : biases)
    write(timeField(row.time) + ',' + textField(row.name) + ',' + lengthField(row.mean) + ',' + lengthField(row.std) +
          '\n');
}
}  // namespace mrpt_ext
