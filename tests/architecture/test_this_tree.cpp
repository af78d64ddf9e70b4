#include <gtest/gtest.h>

#include "rules.h"

// The rules of the architecture, held against this tree.
namespace mrpt_ext::architecture::test_this_tree
{
namespace
{
const SourceTree& thisTree()
{
  static const SourceTree kTree = readTree(MRPT_EXT_SOURCE_DIR);
  return kTree;
}

void expectNone(const Violations& violations)
{
  for (const std::string& violation : violations) ADD_FAILURE() << violation;
}
}  // namespace

TEST(ThisTree, IsRead)
{
  EXPECT_TRUE(thisTree().contains("CMakeLists.txt"));
  EXPECT_TRUE(thisTree().contains("libmrpt-ext/mrpt_ext/geometry/pose.h"));
  EXPECT_TRUE(thisTree().contains("tests/architecture/test_this_tree.cpp"));
}

TEST(ThisTree, IncludesFollowTheDataFlow) { expectNone(checkIncludeDirections(thisTree())); }
TEST(ThisTree, IncludesAreFiles) { expectNone(checkIncludePaths(thisTree())); }
TEST(ThisTree, UnitsDoNotIncludeEachOther) { expectNone(checkUnitCycles(thisTree())); }
TEST(ThisTree, LinksFollowTheDataFlow) { expectNone(checkLinkDirections(thisTree())); }
TEST(ThisTree, EigenOnlyFoldersIncludeNoFramework) { expectNone(checkEigenOnlyFolders(thisTree())); }
TEST(ThisTree, EstimatorsDoNotSeeTruth) { expectNone(checkEstimatorsDoNotSeeTruth(thisTree())); }
TEST(ThisTree, HasOnlyItsTopLevelEntries) { expectNone(checkTopLevel(topLevelEntries(MRPT_EXT_SOURCE_DIR))); }
TEST(ThisTree, FilesAreShort) { expectNone(checkFileLengths(thisTree())); }
TEST(ThisTree, FoldersAreSmall) { expectNone(checkFolderSizes(thisTree())); }
TEST(ThisTree, TypesHaveOneHeader) { expectNone(checkTypeNames(thisTree())); }
TEST(ThisTree, EverySourceIsBuilt) { expectNone(checkSourceLists(thisTree())); }
TEST(ThisTree, PackageConfigNamesEveryDependency) { expectNone(checkPackageConfig(thisTree())); }
TEST(ThisTree, EveryConfigurationIsTested) { expectNone(checkConfigurationsAreTested(thisTree())); }
TEST(ThisTree, KeysTakeTheirDefaultsFromStructs) { expectNone(checkKeyDefaults(thisTree())); }
TEST(ThisTree, DocumentsNameExistingFiles) { expectNone(checkDocumentsNameFiles(thisTree())); }
TEST(ThisTree, TextIsFinishedAndPortable) { expectNone(checkText(thisTree())); }
}  // namespace mrpt_ext::architecture::test_this_tree
