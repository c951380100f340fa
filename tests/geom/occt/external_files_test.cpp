// SPDX-License-Identifier: BSD-3-Clause
// Assemblies whose parts are in files of their own.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <filesystem>
#include <fstream>
#include <gp_Trsf.hxx>
#include <sstream>
#include <stdexcept>
#include <string>

#include "base/error.h"
#include "geom/occt/read_part.h"
#include "tests/support/notes.h"

namespace octet::test {
namespace {

namespace fs = std::filesystem;

/// A directory with an assembly of two boxes, 1 x 1 x 1 and 2 x 2 x 2, in a file each. It goes when the test
/// ends.
class SplitAssembly {
 public:
  SplitAssembly() : directory_(fs::path(::testing::TempDir()) / ("octet_external_files_" + test_name())) {
    fs::create_directories(directory_);
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const TDF_Label top = shapes->NewShape();
    TDataStd_Name::Set(top, "pair");
    for (const int side : {1, 2}) {
      const TDF_Label part = shapes->AddShape(BRepPrimAPI_MakeBox(side, side, side).Shape(), false);
      TDataStd_Name::Set(part, side == 1 ? "small" : "large");
      gp_Trsf beside;
      beside.SetTranslation(gp_Vec(5.0 * side, 0.0, 0.0));
      shapes->AddComponent(top, part, TopLoc_Location(beside));
    }
    shapes->UpdateAssemblies();
    STEPCAFControl_Writer writer;
    if (!writer.Transfer(document, STEPControl_AsIs, "part_") ||
        writer.Write(main().c_str()) != IFSelect_RetDone)
      throw std::runtime_error("cannot write the assembly");
    XCAFApp_Application::GetApplication()->Close(document);
  }
  ~SplitAssembly() { fs::remove_all(directory_); }
  SplitAssembly(const SplitAssembly&) = delete;
  SplitAssembly& operator=(const SplitAssembly&) = delete;

  [[nodiscard]] fs::path main() const { return directory_ / "pair.step"; }
  [[nodiscard]] fs::path part(const std::string& name) const {
    return directory_ / ("part_" + name + ".stp");
  }

 private:
  static std::string test_name() { return ::testing::UnitTest::GetInstance()->current_test_info()->name(); }
  fs::path directory_;
};

TEST(ExternalFiles, AreReadFromTheDirectoryOfTheAssembly) {
  const SplitAssembly assembly;
  ASSERT_TRUE(fs::exists(assembly.part("small")) && fs::exists(assembly.part("large")));
  for (const fs::path& path : {assembly.main(), fs::relative(assembly.main())}) {
    const Model model = read_part(path);
    ASSERT_EQ(model.count(3), 2) << path;
    EXPECT_NEAR(model.region(1).volume + model.region(2).volume, 9.0, 1e-9);
    EXPECT_NEAR(model.box().hi.x(), 12.0, 1e-6);
  }
}

std::string error_of(const fs::path& path) {
  try {
    (void)read_part(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ExternalFiles, AMissingOneIsNamedAndTheRestAreNotTakenForTheWhole) {
  const SplitAssembly assembly;
  fs::remove(assembly.part("small"));
  const std::string error = error_of(assembly.main());
  EXPECT_NE(error.find("'part_small.stp'"), std::string::npos) << error;
  EXPECT_EQ(error.find("part_large"), std::string::npos) << error;
}

TEST(ExternalFiles, ATruncatedOneIsNamedLikeAMissingOne) {
  const SplitAssembly assembly;
  fs::resize_file(assembly.part("small"), fs::file_size(assembly.part("small")) - 10);
  const std::string error = error_of(assembly.main());
  EXPECT_NE(error.find("'part_small.stp'"), std::string::npos) << error;
}

/// A reference of product definition #5 to a file that is not there.
constexpr const char* kReference = R"(
#9045 = DOCUMENT('','',$,#9046);
#9046 = DOCUMENT_TYPE('configuration controlled document version');
#9044 = DOCUMENT_PRODUCT_EQUIVALENCE('equivalence',$,#9045,#9047);
#9047 = PRODUCT_DEFINITION_FORMATION('1','',#9048);
#9048 = PRODUCT('20001','native.stp-Doc','',(#9049));
#9049 = PRODUCT_CONTEXT('',#9050,'');
#9050 = APPLICATION_CONTEXT('');
#9051 = PRODUCT_DEFINITION_WITH_ASSOCIATED_DOCUMENTS('1','',#9047,#9052,(#9053));
#9052 = PRODUCT_DEFINITION_CONTEXT('digital document definition',#9050,'');
#9053 = DOCUMENT_FILE('native.stp','',$,#9054,'',$);
#9054 = DOCUMENT_TYPE('');
#9055 = APPLIED_EXTERNAL_IDENTIFICATION_ASSIGNMENT('native.stp',#9056,#9057,(#9053));
#9056 = IDENTIFICATION_ROLE('external document id and location',$);
#9057 = EXTERNAL_SOURCE(IDENTIFIER('native.stp'));
#9058 = ROLE_ASSOCIATION(#9059,#9060);
#9059 = OBJECT_ROLE('mandatory',$);
#9060 = APPLIED_DOCUMENT_REFERENCE(#9045,'',(#5));
#9066 = DOCUMENT_REPRESENTATION_TYPE('digital',#9053);
)";

TEST(ExternalFiles, AMissingOneIsNotNeededWhereThePartIsInTheFile) {
  const SplitAssembly assembly;
  std::ifstream in(assembly.part("small"), std::ios::binary);
  std::ostringstream content;
  content << in.rdbuf();
  in.close();
  std::string text = content.str();
  ASSERT_NE(text.find("#5 = PRODUCT_DEFINITION("), std::string::npos);
  text.insert(text.rfind("ENDSEC;"), kReference);
  std::ofstream(assembly.part("small"), std::ios::binary) << text;
  const Model model = read_part(assembly.part("small"));
  ASSERT_EQ(model.count(3), 1);
  EXPECT_NEAR(model.region(1).volume, 1.0, 1e-9);
  EXPECT_TRUE(has_note(model, "'native.stp'"));
}

}  // namespace
}  // namespace octet::test
