#include "mrpt_ext/report/objects_csv.h"

#include "mrpt_ext/report/csv_field.h"

namespace mrpt_ext
{
void objectsCsv(const DiskBackedSequence<ObjectRow>& objects, const TextSink& write)
{
  write("t,label,x,y,cxx,cxy,cyy,x_robot,y_robot\n");
  for (const ObjectRow& row : objects)
    write(timeField(row.time) + ',' + textField(row.label) + ',' + lengthField(row.position.x()) + ',' +
          lengthField(row.position.y()) + ',' + covarianceField(row.covariance(0, 0)) + ',' +
          covarianceField(row.covariance(0, 1)) + ',' + covarianceField(row.covariance(1, 1)) + ',' +
          lengthField(row.position_robot.x()) + ',' + lengthField(row.position_robot.y()) + '\n');
}
}  // namespace mrpt_ext
