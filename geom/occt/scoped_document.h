// SPDX-License-Identifier: BSD-3-Clause
// An XCAF document for as long as it is needed.
#pragma once

#include <Standard_Failure.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFApp_Application.hxx>

namespace octet {

/// An XCAF document that is closed when it goes.
class ScopedDocument {
 public:
  ScopedDocument() { XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document_); }
  ~ScopedDocument() {
    try {
      XCAFApp_Application::GetApplication()->Close(document_);
    } catch (const Standard_Failure&) {
      // Nothing is lost: the document is only our scratch paper.
    }
  }
  ScopedDocument(const ScopedDocument&) = delete;
  ScopedDocument& operator=(const ScopedDocument&) = delete;
  Handle(TDocStd_Document) & get() { return document_; }

 private:
  Handle(TDocStd_Document) document_;
};

}  // namespace octet
