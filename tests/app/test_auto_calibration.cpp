#include "mrpt_ext/app/auto_calibration.h"

#include <gtest/gtest.h>

#include "mrpt_ext/configuration/localization_keys.h"

namespace mrpt_ext::test_calibration_ini
{
TEST(CalibrationIni, HasWhatWasAdopted)
{
  AdoptedCalibration adopted;
  adopted.values = {{"Sensor_up", "delay_s", "0.092", 0.003},
                    {"Sensor_uwb", "landmark_bias_range_m", "1:0.050 4:-0.120", 0.01}};
  const std::string text = calibrationIni(adopted);
  const Settings settings = Settings::parse(text, "calibration.ini", localizationKeys());
  EXPECT_EQ(settings.number("Sensor_up", "delay_s"), 0.092);
  EXPECT_EQ(settings.text("Sensor_uwb", "landmark_bias_range_m"), "1:0.050 4:-0.120");
  EXPECT_NE(text.find("[Sensor_up]\ndelay_s = 0.092  ; +- 0.003\n"), std::string::npos) << text;
}
}  // namespace mrpt_ext::test_calibration_ini
