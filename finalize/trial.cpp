// SPDX-License-Identifier: BSD-3-Clause
// Operations that are done together, and taken back together unless they are kept.
#include "finalize/trial.h"

namespace octet {

Trial::Trial(Workshop& shop) : shop_(shop), report_(shop.report) {
  open_journal(shop.mesh);
  shop.guard.open_journal(shop.mesh.points.size());
  shop.flats.open_trial();
}

Trial::~Trial() {
  if (kept_) return;
  take_back(shop_.mesh);
  shop_.guard.take_back();
  shop_.flats.take_back_trial();
  shop_.report = report_;
}

void Trial::keep() {
  close_journal(shop_.mesh);
  shop_.guard.close_journal();
  shop_.flats.keep_trial();
  kept_ = true;
}

}  // namespace octet
