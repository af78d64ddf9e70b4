#include <iostream>

#include "mrpt_ext/maps/register_all_classes.h"
#include "mrpt_ext/pipeline/app_shell.h"
#include "mrpt_ext/pipeline/localization_app.h"

int main(int argc, char** argv)
{
  mrpt_ext::registerAllClasses();
  return mrpt_ext::LocalizationApp(std::cout, std::cerr).run(mrpt_ext::argumentsOf(argc, argv));
}
