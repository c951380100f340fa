// SPDX-License-Identifier: BSD-3-Clause
// Keeps OCCT from printing while it is in scope.
#pragma once

#include <Message.hxx>
#include <Message_Messenger.hxx>

namespace octet {

/// Takes the printers off OCCT's default messenger and puts them back. For processes of our own: while a host
/// has another thread that sends messages, nobody may touch the printers.
class Silence {
 public:
  Silence() : printers_(Message::DefaultMessenger()->Printers()) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
  }
  ~Silence() { Message::DefaultMessenger()->ChangePrinters() = printers_; }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  Message_SequenceOfPrinters printers_;
};

}  // namespace octet
