#include <gtest/gtest.h>

#include "rules.h"

// Each rule is shown a small tree that breaks it, beside the nearest one that does not.
namespace mrpt_ext::architecture::test_rules
{
namespace
{
SourceTree file(const std::string& path, const std::string& text) { return {{path, text}}; }

std::string include(const std::string& header) { return "#include \"mrpt_ext/" + header + "\"\n"; }
}  // namespace

TEST(IncludeDirections, LowerFoldersDoNotUseHigherOnes)
{
  EXPECT_EQ(checkIncludeDirections(file("libmrpt-ext/mrpt_ext/geometry/a.h", include("solvers/b.h"))).size(), 1U);
  EXPECT_EQ(checkIncludeDirections(file("libmrpt-ext/mrpt_ext/filter/a.cpp", include("localizers/b.h"))).size(), 1U);
  EXPECT_EQ(checkIncludeDirections(file("maps/mrpt_ext/maps/a.h", include("filter/b.h"))).size(), 1U);
  EXPECT_TRUE(checkIncludeDirections(file("libmrpt-ext/mrpt_ext/solvers/a.h", include("geometry/b.h"))).empty());
  EXPECT_TRUE(checkIncludeDirections(file("libmrpt-ext/mrpt_ext/solvers/a.cpp", include("solvers/b.h"))).empty());
}

TEST(IncludeDirections, OnlyAppsAndTestsUseApp)
{
  EXPECT_EQ(checkIncludeDirections(file("libmrpt-ext/mrpt_ext/localizers/a.h", include("app/b.h"))).size(), 1U);
  EXPECT_EQ(checkIncludeDirections(file("libmrpt-ext/mrpt_ext/unlisted/a.h", include("app/b.h"))).size(), 1U);
  EXPECT_TRUE(checkIncludeDirections(file("apps/x/main.cpp", include("app/b.h"))).empty());
  EXPECT_TRUE(checkIncludeDirections(file("tests/app/a.cpp", include("app/b.h"))).empty());
}

TEST(IncludeDirections, OurHeadersAreNamedInFull)
{
  EXPECT_EQ(checkIncludeDirections(file("libmrpt-ext/mrpt_ext/solvers/a.cpp", "#include \"a.h\"\n")).size(), 1U);
  EXPECT_TRUE(checkIncludeDirections(file("libmrpt-ext/mrpt_ext/solvers/a.cpp", "#include <vector>\n")).empty());
}

TEST(IncludeDirections, SubfoldersHaveAnOrderToo)
{
  const std::string low = "libmrpt-ext/mrpt_ext/filter/particles/a.h", high = "libmrpt-ext/mrpt_ext/filter/kalman/a.h";
  EXPECT_EQ(checkIncludeDirections(file(low, include("filter/kalman/b.h"))).size(), 1U);
  EXPECT_EQ(checkIncludeDirections(file(high, include("filter/b.h"))).size(), 1U);
  EXPECT_TRUE(checkIncludeDirections(file(high, include("filter/particles/b.h"))).empty());
  EXPECT_TRUE(checkIncludeDirections(file(high, include("filter/kalman/b.h"))).empty());
}

TEST(IncludePaths, AreFilesBelowARoot)
{
  const std::string header = "libmrpt-ext/mrpt_ext/solvers/b.h", user = "tests/a.cpp";
  EXPECT_EQ(checkIncludePaths({{user, include("solvers/b.h")}}).size(), 1U);
  EXPECT_EQ(checkIncludePaths({{user, include("solvers/b.h")}, {"libmrpt-ext/solvers/b.h", ""}}).size(), 1U);
  EXPECT_TRUE(checkIncludePaths({{user, include("solvers/b.h")}, {header, ""}}).empty());
  EXPECT_TRUE(checkIncludePaths({{user, include("maps/b.h")}, {"maps/mrpt_ext/maps/b.h", ""}}).empty());
}

TEST(UnitCycles, AreFoundAcrossHeaderAndSource)
{
  const std::string a = "libmrpt-ext/mrpt_ext/solvers/a", b = "libmrpt-ext/mrpt_ext/solvers/b",
                    c = "libmrpt-ext/mrpt_ext/solvers/c";
  EXPECT_EQ(checkUnitCycles({{a + ".h", include("solvers/b.h")}, {b + ".cpp", include("solvers/a.h")}}).size(), 1U);
  EXPECT_EQ(checkUnitCycles({{a + ".h", include("solvers/b.h")},
                             {b + ".h", include("solvers/c.h")},
                             {c + ".cpp", include("solvers/a.h")}})
                .size(),
            1U);
  EXPECT_TRUE(checkUnitCycles({{a + ".cpp", include("solvers/a.h") + include("solvers/b.h")}, {b + ".h", ""}}).empty());
}

TEST(TypeNames, StandInOneHeader)
{
  const std::string a = "libmrpt-ext/mrpt_ext/solvers/a.h", b = "maps/mrpt_ext/maps/b.h";
  EXPECT_EQ(checkTypeNames({{a, "struct Ray\n{\n};\n"}, {b, "class Ray : Line\n{\n};\n"}}).size(), 1U);
  EXPECT_EQ(checkTypeNames({{a, "enum class Ray\n{\n};\n"}, {b, "using Ray = int;\n"}}).size(), 1U);
  EXPECT_TRUE(checkTypeNames({{a, "struct Ray\n{\n};\n"}, {b, "struct Ray;\n"}}).empty());
  EXPECT_TRUE(
      checkTypeNames({{a, "struct Ray\n{\n};\n"}, {b, "struct Line\n{\n  struct Ray\n  {\n  };\n};\n"}}).empty());
  EXPECT_TRUE(checkTypeNames({{a, "struct Ray\n{\n};\n"}, {"tests/b.h", "struct Ray\n{\n};\n"}}).empty());
}

TEST(LinkDirections, FollowTheIncludeDirections)
{
  const std::string path = "libmrpt-ext/mrpt_ext/likelihood/CMakeLists.txt";
  EXPECT_EQ(checkLinkDirections(file(path, "add(likelihood PUBLIC mrpt_ext::filter)")).size(), 1U);
  EXPECT_TRUE(checkLinkDirections(file(path, "add(likelihood PUBLIC mrpt_ext::geometry)")).empty());
}

TEST(EigenOnlyFolders, RefuseFrameworkHeaders)
{
  EXPECT_EQ(checkEigenOnlyFolders(file("libmrpt-ext/mrpt_ext/filter/a.h", "#include <mrpt/poses/CPose2D.h>\n")).size(),
            1U);
  EXPECT_EQ(checkEigenOnlyFolders(file("libmrpt-ext/mrpt_ext/report/a.h", "#include <opencv2/core.hpp>\n")).size(), 1U);
  EXPECT_EQ(checkEigenOnlyFolders(file("libmrpt-ext/mrpt_ext/vision/a.h", "#include <mrpt/img/CImage.h>\n")).size(),
            1U);
  EXPECT_TRUE(checkEigenOnlyFolders(file("libmrpt-ext/mrpt_ext/vision/a.h", "#include <opencv2/core.hpp>\n")).empty());
  EXPECT_TRUE(checkEigenOnlyFolders(file("libmrpt-ext/mrpt_ext/filter/a.h", "#include <Eigen/Core>\n")).empty());
  EXPECT_TRUE(checkEigenOnlyFolders(file("maps/mrpt_ext/maps/a.h", "#include <mrpt/maps/CMetricMap.h>\n")).empty());
}

TEST(EstimatorsDoNotSeeTruth, InCodeOfAnyCase)
{
  const std::string path = "libmrpt-ext/mrpt_ext/filter/a.cpp";
  EXPECT_EQ(checkEstimatorsDoNotSeeTruth(file(path, "void f(const Trajectory& truth);")).size(), 1U);
  EXPECT_EQ(checkEstimatorsDoNotSeeTruth(file(path, "auto g = log.groundTruth();")).size(), 1U);
  EXPECT_EQ(checkEstimatorsDoNotSeeTruth(file(path, "void f(const RunContext& context);")).size(), 1U);
  EXPECT_TRUE(checkEstimatorsDoNotSeeTruth(file(path, "int a; // never sees the truth\n")).empty());
  EXPECT_TRUE(checkEstimatorsDoNotSeeTruth(file(path, "f(\"truth\"); /* ground_truth\n */")).empty());
  EXPECT_TRUE(checkEstimatorsDoNotSeeTruth(file("libmrpt-ext/mrpt_ext/evaluation/a.h", "int truth;")).empty());
}

TEST(TopLevel, RefusesAnotherEntry)
{
  EXPECT_EQ(checkTopLevel({"CMakeLists.txt", "docs", "apps", ".clang-format"}).size(), 1U);
  EXPECT_TRUE(checkTopLevel({"CMakeLists.txt", "apps", ".clang-format"}).empty());
}

TEST(FileLengths, CountLines)
{
  const auto lines = [](int count)
  {
    std::string text;
    for (int i = 0; i < count; ++i) text += "\n";
    return text;
  };
  EXPECT_EQ(checkFileLengths(file("libmrpt-ext/mrpt_ext/solvers/a.cpp", lines(401))).size(), 1U);
  EXPECT_EQ(checkFileLengths(file("apps/x/main.cpp", lines(51))).size(), 1U);
  EXPECT_TRUE(checkFileLengths(file("libmrpt-ext/mrpt_ext/solvers/a.cpp", lines(400))).empty());
  EXPECT_TRUE(checkFileLengths(file("apps/x/main.cpp", lines(50))).empty());
  EXPECT_TRUE(checkFileLengths(file("README.md", lines(1000))).empty());
}

TEST(FolderSizes, AddUpTheFilesOfAFolder)
{
  const std::string many(3000, '\n'), folder = "libmrpt-ext/mrpt_ext/filter/";
  EXPECT_EQ(checkFolderSizes({{folder + "a.h", many}, {folder + "b.cpp", many}}).size(), 1U);
  EXPECT_TRUE(checkFolderSizes({{folder + "a.h", many}, {folder + "kalman/b.cpp", many}}).empty());
}

TEST(SourceLists, NameEverySource)
{
  const std::string list = "libmrpt-ext/mrpt_ext/solvers/CMakeLists.txt", source = "libmrpt-ext/mrpt_ext/solvers/a.cpp";
  EXPECT_EQ(checkSourceLists({{list, "add(x SOURCES ba.cpp)"}, {source, ""}}).size(), 1U);
  EXPECT_EQ(checkSourceLists({{source, ""}}).size(), 1U);
  EXPECT_EQ(checkSourceLists({{list, "file(GLOB sources *.cpp)"}}).size(), 1U);
  EXPECT_TRUE(checkSourceLists({{list, "add(x SOURCES a.cpp)"}, {source, ""}}).empty());
  EXPECT_TRUE(checkSourceLists({{"apps/CMakeLists.txt", "add(x/main.cpp)"}, {"apps/x/main.cpp", ""}}).empty());
}

TEST(PackageConfig, LooksUpWhatTheLibrariesLookUp)
{
  const std::string config = "libmrpt-ext/mrpt_ext-config.cmake.in";
  EXPECT_EQ(checkPackageConfig(file("CMakeLists.txt", "")).size(), 1U);
  EXPECT_EQ(checkPackageConfig({{config, "find_dependency(ZLIB)"}, {"CMakeLists.txt", "find_package(TBB)"}}).size(),
            1U);
  EXPECT_TRUE(checkPackageConfig({{config, "find_dependency(TBB)"}, {"CMakeLists.txt", "find_package(TBB)"}}).empty());
}

TEST(Configurations, AreNamedByATest)
{
  const SourceTree untested{{"ini/some-app/room.ini", ""},
                            {"tests/a.cpp", "run(\"some-app\", \"room-2\")"},
                            {"tests/b.cpp", "run(\"other-app\", \"room\")"}};
  EXPECT_EQ(checkConfigurationsAreTested(untested).size(), 1U);
  const SourceTree tested{{"ini/some-app/room.ini", ""}, {"tests/a.cpp", "run(\"ini/some-app/room.ini\")"}};
  EXPECT_TRUE(checkConfigurationsAreTested(tested).empty());
}

TEST(KeyDefaults, AreReadFromStructs)
{
  const auto keys = [](const std::string& call)
  { return file("libmrpt-ext/mrpt_ext/configuration/a_keys.cpp", "KeySection(\"A\")" + call + ";\n"); };
  EXPECT_EQ(checkKeyDefaults(keys(".number(\"x\", \"m\", 0.5, range, \"X.\")")).size(), 1U);
  EXPECT_EQ(checkKeyDefaults(keys(".degrees(\"x\",\n   \"deg\", -1, range, \"X.\")")).size(), 1U);
  EXPECT_EQ(checkKeyDefaults(keys(".integer(\"x\", \"\", 3, range, \"X.\").flag(\"y\", true, \"Y.\")")).size(), 2U);
  EXPECT_TRUE(checkKeyDefaults(keys(".number(\"x\", \"m\", options.x, {0, 1}, \"X.\")")).empty());
  EXPECT_TRUE(checkKeyDefaults(keys(".number(\"x\", \"\", kUnset, range, \"X: 0.5.\")")).empty());
}

TEST(Documents, NameExistingFiles)
{
  const auto documented = [](const std::string& text) {
    return SourceTree{{"README.md", text}, {"libmrpt-ext/mrpt_ext/solvers/a.h", ""}, {"ini/app/room.ini", ""}};
  };
  EXPECT_EQ(checkDocumentsNameFiles(documented("see `b.h`")).size(), 1U);
  EXPECT_EQ(checkDocumentsNameFiles(documented("    run ini/app/rooms.ini\n")).size(), 1U);
  EXPECT_TRUE(checkDocumentsNameFiles(documented("`a.h`, `solvers/a.h`, ini/app/room.ini, `<name>.ini`")).empty());
}

TEST(Text, RefusesUnfinishedWorkAndMachinePaths)
{
  const std::string slash = "/";
  EXPECT_EQ(checkText(file("a.cpp", std::string("// TO") + "DO: later\n")).size(), 1U);
  EXPECT_EQ(checkText(file("a.md", std::string("FIX") + "ME\n")).size(), 1U);
  EXPECT_EQ(checkText(file("a.sh", "cd " + slash + "home/someone/data\n")).size(), 1U);
  EXPECT_EQ(checkText(file("a.sh", slash + "tmp/x\n")).size(), 1U);
  EXPECT_TRUE(checkText(file("a.sh", "ls out/tmp/x \"$HOME/data\" " + slash + "usr/share/mrpt\n")).empty());
}

TEST(CodeOnly, DropsCommentsAndStrings)
{
  EXPECT_EQ(codeOnly("a // b\nc"), "a  \nc");
  EXPECT_EQ(codeOnly("a /* b\n * c */ d"), "a   d");
  EXPECT_EQ(codeOnly(R"(f("a // \" b", c))"), "f( , c)");
}
}  // namespace mrpt_ext::architecture::test_rules
