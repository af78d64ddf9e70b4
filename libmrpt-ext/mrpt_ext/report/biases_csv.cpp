#include "mrpt_ext/report/biases_csv.h"

#include "mrpt_ext/report/csv_field.h"

namespace mrpt_ext
{
void biasesCsv(const DiskBackedSequence<BiasRow>& biases, const TextSink& write)
{
  write("t,bias,mean,std\n");
  for (const BiasRow& row : biases)
    write(timeField(row.time) + ',' + textField(row.name) + ',' + lengthField(row.mean) + ',' + lengthField(row.std) +
          '\n');
}
}  // namespace mrpt_ext
