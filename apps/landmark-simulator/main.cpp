#include <iostream>

#include "mrpt_ext/app/app_shell.h"
#include "mrpt_ext/app/simulator_app.h"
#include "mrpt_ext/maps/register_all_classes.h"

int main(int argc, char** argv)
{
  mrpt_ext::registerAllClasses();
  return mrpt_ext::SimulatorApp(std::cout, std::cerr).run(mrpt_ext::argumentsOf(argc, argv));
}
