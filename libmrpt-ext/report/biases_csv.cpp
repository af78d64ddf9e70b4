#include "mrpt_ext/report/biases_csv.h"

#include "mrpt_ext/report/csv_field.h"

namespace mrpt_ext
{
std::string biasesCsv(const std::vector<BiasRow>& biases)
{
  std::string text = "t,bias,mean,std\n";
  for (const BiasRow& row : biases)
    text += timeField(row.time) + ',' + textField(row.name) + ',' + lengthField(row.mean) + ',' + lengthField(row.std) +
            '\n';
  return text;
}
}  // namespace mrpt_ext
