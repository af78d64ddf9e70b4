#include "mrpt_ext/report/objects_csv.h"

#include "mrpt_ext/report/csv_field.h"

namespace mrpt_ext
{
std::string objectsCsv(const std::vector<ObjectRow>& objects)
{
  std::string text = "t,label,x,y,cxx,cxy,cyy,x_robot,y_robot\n";
  for (const ObjectRow& row : objects)
    text += timeField(row.time) + ',' + textField(row.label) + ',' + lengthField(row.position.x()) + ',' +
            lengthField(row.position.y()) + ',' + covarianceField(row.covariance(0, 0)) + ',' +
            covarianceField(row.covariance(0, 1)) + ',' + covarianceField(row.covariance(1, 1)) + ',' +
            lengthField(row.position_robot.x()) + ',' + lengthField(row.position_robot.y()) + '\n';
  return text;
}
}  // namespace mrpt_ext
