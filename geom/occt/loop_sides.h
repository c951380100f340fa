// SPDX-License-Identifier: BSD-3-Clause
// Faces on spheres and tori as a STEP file has them, not as OCCT's reader leaves them.
#pragma once

#include <Standard_Transient.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

namespace octet {

/// A loop on a sphere bounds two parts of it, and one on a torus may; which one is the face tells the way
/// round. OCCT's reader (7.6) makes the curves in (u,v) anew, takes some of them to be a turn off where the
/// loop meets the seam, and then turns the loop, and the face with it, so that they fit: a hollow made by a
/// ball becomes a bump, of a ball on a rod two parts overlap. While this object is in scope, faces on spheres
/// that come out of the reader with a loop that runs the other way, or with another area than the file's
/// loops bound, and faces on tori whose loop runs the other way, are made anew with cuts clear of their
/// loops. Faces whose loops disagree with their neighbours' in the file are left to the reader. The STEP
/// reader of OCCT 7.9 does not ask the hook that this uses, so its faces are taken as they come. Not
/// thread-safe: the hook is OCCT's only one (the caller holds the lock).
class KeepLoopSides {
 public:
  KeepLoopSides();
  ~KeepLoopSides();
  KeepLoopSides(const KeepLoopSides&) = delete;
  KeepLoopSides& operator=(const KeepLoopSides&) = delete;

  /// Faces that were made anew, as they came out of the reader in the end.
  [[nodiscard]] const std::vector<TopoDS_Shape>& made() const;
  /// Those that are not what the file has, and could not be made anew.
  [[nodiscard]] const std::vector<TopoDS_Shape>& left() const;

 private:
  struct Hook;
  opencascade::handle<Hook> hook_;
  opencascade::handle<Standard_Transient> before_;
};

}  // namespace octet
