#include "mrpt_ext/configuration/default_configuration.h"

namespace mrpt_ext
{
std::string_view defaultConfiguration()
{
  return R"([LocalizationExperiment]
particles_count         = 2000
initial_particles_count = 20000
init_PDF_mode           = analytic

[MotionModel]
std_xy_per_m           = 0.05  ; m after one metre
std_phi_deg_per_deg    = 0.3   ; deg after a turn of one degree
std_phi_deg_per_m      = 2     ; deg after one metre
std_xy_per_sqrt_s      = 0.01  ; m after one second
std_phi_deg_per_sqrt_s = 0.5   ; deg after one second
)";
}
}  // namespace mrpt_ext
