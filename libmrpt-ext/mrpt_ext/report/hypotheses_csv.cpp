#include "mrpt_ext/report/hypotheses_csv.h"

#include "mrpt_ext/report/csv_field.h"

namespace mrpt_ext
{
void hypothesesCsv(const DiskBackedSequence<HypothesisRow>& hypotheses, const TextSink& write)
{
  write("t,rank,x,y,phi_deg,weight,source\n");
  for (const HypothesisRow& row : hypotheses)
    write(timeField(row.time) + ',' + std::to_string(row.rank) + ',' + lengthField(row.pose.x) + ',' +
          lengthField(row.pose.y) + ',' + angleField(row.pose.phi) + ',' + shareField(row.weight) + ',' +
          textField(row.source) + '\n');
}
}  // namespace mrpt_ext
