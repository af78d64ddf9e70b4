#include <iostream>

#include "mrpt_ext/app/apps.h"

int main(int argc, char** argv)
{
  return mrpt_ext::runLocalizationReport(mrpt_ext::argumentsOf(argc, argv), std::cout, std::cerr);
}
