// SPDX-License-Identifier: BSD-3-Clause
// What is smaller than a file is accurate to goes where the mesh cannot be closed with it.
#include "app/mesh_file.h"

#include <gtest/gtest.h>

#include <TopLoc_Location.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include <string>
#include <vector>

#include "tests/support/chamfered_block.h"
#include "tests/support/crossed.h"

namespace octet::test {
namespace {

class MeshFile : public testing::Test {
 protected:
  /// Meshes a block with a chamfer 0.0007 mm wide by a mesher who finds three faults in it, and `left` in the
  /// block without.
  MeshedFile run(const std::string& accuracy, std::size_t left, const ReadOptions& reading = {}) {
    const ChamferedBlock block(accuracy, "MM", beside_);
    const auto mesh = [&](const Model& model, LargeMesh large_mesh) {
      faces_.push_back(model.count(2));
      asked_.push_back(large_mesh);
      MeshResult result;
      result.report.size = size_;
      result.report.faults.resize(model.count(2) == 7 ? 3 : left, Fault{at_, {}, "", ""});
      if (large_ > 0.0 && large_mesh != LargeMesh::kNever) result.report.faults.clear();
      if (large_ > 0.0 && !result.report.faults.empty()) result.report.left_large = large_;
      if (result.report.faults.empty()) result.report.status = MeshStatus::kComplete;
      return result;
    };
    Observer silent;
    return mesh_file(block.path(), reading, mesh, silent);
  }

  std::vector<int> faces_;  ///< of the models that were meshed
  std::vector<LargeMesh> asked_;
  double size_ = 0.01;   ///< that the mesher tells
  double large_ = 0.0;   ///< elements of a mesh without faults
  TopoDS_Shape beside_;  ///< another part of the file
  ModelRef at_;          ///< of the faults
};

/// Of three faces, clear of the block.
TopoDS_Shape folded_bar_beside() {
  gp_Trsf away;
  away.SetTranslation(gp_Vec(-50.0, 0.0, 0.0));
  return folded_bar(2.5).Moved(TopLoc_Location(away));
}

TEST_F(MeshFile, IsMadeAgainWithoutWhatTheFileIsNotAccurateTo) {
  const MeshedFile made = run("0.01", 0);
  EXPECT_EQ(faces_, (std::vector<int>{7, 6}));
  EXPECT_EQ(made.model.count(2), 6);
  EXPECT_EQ(made.result.report.status, MeshStatus::kComplete);
  ASSERT_FALSE(made.model.notes().empty());
  EXPECT_NE(made.model.notes().front().find("what is smaller than 0.001732 mm was taken away"),
            std::string::npos)
      << made.model.notes().front();
  EXPECT_NE(made.model.notes().front().find("with it the mesh had 3 faults"), std::string::npos);
  ASSERT_EQ(made.result.report.times.size(), 2u);
  EXPECT_EQ(made.result.report.times[0].name, "other tries");
  EXPECT_EQ(made.result.report.times[1].name, "reading");
}

TEST_F(MeshFile, IsKeptWhereTheOtherHasFaultsToo) {
  const MeshedFile made = run("0.01", 1);
  EXPECT_EQ(faces_, (std::vector<int>{7, 6}));
  EXPECT_EQ(made.model.count(2), 7);
  EXPECT_EQ(made.result.report.faults.size(), 3u);
}

TEST_F(MeshFile, IsMadeOnceWhereTheFileIsAccurate) {
  EXPECT_EQ(run("1.E-07", 0).model.count(2), 7);
  EXPECT_EQ(faces_, (std::vector<int>{7}));
}

TEST_F(MeshFile, IsMadeOnceWhereASmallestFeatureIsGiven) {
  ReadOptions reading;
  reading.smallest_feature = 2e-4;
  EXPECT_EQ(run("0.01", 0, reading).model.count(2), 7);
  EXPECT_EQ(faces_, (std::vector<int>{7}));
}

TEST_F(MeshFile, IsMadeAgainWithoutWhatNoElementResolves) {
  size_ = 10.0;
  const MeshedFile made = run("1.E-07", 0);
  EXPECT_EQ(faces_, (std::vector<int>{7, 6}));
  EXPECT_EQ(made.model.count(2), 6);
  EXPECT_EQ(made.result.report.status, MeshStatus::kComplete);
  ASSERT_FALSE(made.model.notes().empty());
  // 1e-4 of the diagonal of 173.2 mm.
  const std::string& note = made.model.notes().front();
  EXPECT_NE(note.find("what is smaller than 0.017 mm was taken away, as with --defeature 0.017:"),
            std::string::npos)
      << note;
  EXPECT_NE(note.find("with it the mesh had 3 faults, and the size is 10 mm"), std::string::npos) << note;
  ASSERT_EQ(made.result.report.times.size(), 2u);
  EXPECT_EQ(made.result.report.times[0].name, "other tries");
}

TEST_F(MeshFile, IsMadeOnceWhereFacesCrossDeeperThanWhatWouldGo) {
  size_ = 10.0;
  beside_ = folded_bar_beside();
  EXPECT_EQ(run("0.01", 3).result.report.faults.size(), 3u);
  EXPECT_EQ(faces_.size(), 1u);
}

TEST_F(MeshFile, IsMadeAgainWhereFacesCrossButFaultsAreElsewhere) {
  size_ = 10.0;
  beside_ = folded_bar_beside();
  at_ = model_face(1);  // of the block
  run("1.E-07", 3);
  EXPECT_EQ(faces_, (std::vector<int>{10, 9}));
}

TEST_F(MeshFile, TriesTheFilesWordBeforeTheSize) {
  size_ = 10.0;
  const MeshedFile made = run("0.01", 1);
  EXPECT_EQ(faces_, (std::vector<int>{7, 6, 6}));
  EXPECT_EQ(made.model.count(2), 7);
  EXPECT_EQ(made.result.report.faults.size(), 3u);
}

TEST_F(MeshFile, IsMadeWithoutWhatIsSmallestBeforeItIsMadeLarge) {
  large_ = 960'000.0;
  const MeshedFile made = run("0.01", 0);
  EXPECT_EQ(faces_, (std::vector<int>{7, 6}));
  EXPECT_EQ(made.model.count(2), 6);
  const std::string& note = made.model.notes().front();
  EXPECT_NE(note.find("with it the mesh had 3 faults, or about 9.6e+05 elements"), std::string::npos) << note;
}

TEST_F(MeshFile, IsMadeLargeWhereNothingElseHelps) {
  large_ = 960'000.0;
  const MeshedFile made = run("0.01", 1);
  EXPECT_EQ(faces_, (std::vector<int>{7, 6, 7}));
  EXPECT_EQ(asked_, (std::vector{LargeMesh::kNever, LargeMesh::kNever, LargeMesh::kAtOnce}));
  EXPECT_EQ(made.model.count(2), 7);
  EXPECT_EQ(made.result.report.status, MeshStatus::kComplete);
  ASSERT_EQ(made.result.report.times.size(), 2u);
  EXPECT_EQ(made.result.report.times[0].name, "other tries");
  EXPECT_EQ(made.result.report.times[1].name, "reading");
}

TEST_F(MeshFile, MayBeLargeWhereASmallestFeatureIsGiven) {
  ReadOptions reading;
  reading.smallest_feature = 2e-4;
  large_ = 960'000.0;
  EXPECT_EQ(run("0.01", 0, reading).result.report.status, MeshStatus::kComplete);
  EXPECT_EQ(asked_, std::vector{LargeMesh::kLast});
}

TEST_F(MeshFile, KeepsWhatElementsOfTheSizeMayResolve) {
  size_ = 0.05;
  EXPECT_EQ(run("1.E-07", 0).model.count(2), 7);
  EXPECT_EQ(faces_, (std::vector<int>{7}));
}

}  // namespace
}  // namespace octet::test
