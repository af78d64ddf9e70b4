#include <iostream>

#include "mrpt_ext/app/apps.h"
#include "mrpt_ext/maps/register_all_classes.h"

int main(int argc, char** argv)
{
  mrpt_ext::registerAllClasses();
  return mrpt_ext::runDataset2Rawlog(mrpt_ext::argumentsOf(argc, argv), std::cout, std::cerr);
}
