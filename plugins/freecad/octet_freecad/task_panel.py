# SPDX-License-Identifier: BSD-3-Clause
"""The panel: how fine, the run, and what came of it."""
import re

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .commands import ICON
from .groups import element_of
from .mesher import Mesher
from .program import OctetError

POLL = 100  # milliseconds


class TaskPanel:
    """For one mesh object. The window stays alive while the program runs."""

    def __init__(self, obj):
        self.obj = obj
        self.mesher = None
        self.form = self._make_form()
        self.timer = QtCore.QTimer()
        self.timer.setInterval(POLL)
        self.timer.timeout.connect(self._poll)
        self._show_outcome()

    def _make_form(self):
        form = QtGui.QWidget()
        form.setWindowTitle("Octet mesh")
        form.setWindowIcon(QtGui.QIcon(ICON))
        rows = QtGui.QFormLayout(form)
        self.size = self._quantity(self.obj.Size, "0: from the part's own dimensions")
        self.min_size = self._quantity(self.obj.MinSize, "0: a thirty-second of the size")
        self.order = QtGui.QComboBox()
        self.order.addItems(["2nd", "1st"])
        self.order.setCurrentText(self.obj.ElementOrder)
        self.local = QtGui.QPlainTextEdit("\n".join(self.obj.LocalSizes))
        self.local.setPlaceholderText("Face12=0.5\nEdge3=/24")
        self.local.setMaximumHeight(80)
        self.add = QtGui.QPushButton("Add selection with size")
        self.add.clicked.connect(self._add_selection)
        self.add_size = self._quantity(
            FreeCAD.Units.Quantity("1 mm"), "Of the faces, edges and vertices selected"
        )
        self.start = QtGui.QPushButton("Mesh")
        self.start.clicked.connect(self._start_or_stop)
        self.bar = QtGui.QProgressBar()
        self.bar.setRange(0, 100)
        self.outcome = QtGui.QListWidget()
        self.outcome.setWordWrap(True)
        self.outcome.itemClicked.connect(self._select_named)
        rows.addRow("Size", self.size)
        rows.addRow("Least size", self.min_size)
        rows.addRow("Elements", self.order)
        rows.addRow("Local sizes", self.local)
        rows.addRow(self.add, self.add_size)
        rows.addRow(self.start)
        rows.addRow(self.bar)
        rows.addRow(self.outcome)
        return form

    @staticmethod
    def _quantity(value, tip):
        box = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
        box.setProperty("unit", "mm")
        box.setProperty("minimum", 0.0)
        box.setProperty("rawValue", value.Value)
        box.setToolTip(tip)
        return box

    def _add_selection(self):
        """A line of local sizes for each face, edge or vertex of the part that is selected."""
        size = self.add_size.property("rawValue")
        for selection in FreeCADGui.Selection.getSelectionEx(self.obj.Document.Name):
            if selection.Object != self.obj.Part:
                continue
            for sub in selection.SubElementNames:
                element = element_of(sub)
                if element is not None:
                    self.local.appendPlainText(f"{element[0]}{element[1]}={size:g}")

    def _accept_words(self):
        self.obj.Size = self.size.property("rawValue")
        self.obj.MinSize = self.min_size.property("rawValue")
        self.obj.ElementOrder = self.order.currentText()
        self.obj.LocalSizes = [line for line in self.local.toPlainText().splitlines() if line.strip()]

    def _start_or_stop(self):
        if self.mesher is not None:
            self.mesher.cancel()
            return
        self._accept_words()
        self.outcome.clear()
        mesher = Mesher(self.obj)
        try:
            mesher.start()
        except OctetError as error:
            self.outcome.addItem(str(error))
            return
        self.mesher = mesher
        self.start.setText("Stop")
        self.timer.start()

    def _poll(self):
        if self.mesher.running():
            self.bar.setValue(int(100 * self.mesher.run.fraction))
            self.bar.setFormat(f"{self.mesher.run.stage} %p%")
            return
        self.timer.stop()
        try:
            self.mesher.finish()
            self.bar.setValue(100)
        except OctetError as error:
            FreeCAD.Console.PrintError(f"Octet: {error}\n")
            self.bar.setValue(0)
        self.bar.setFormat("")
        self.mesher = None
        self.start.setText("Mesh")
        self._show_outcome()
        self.obj.ViewObject.show()

    def _show_outcome(self):
        self.outcome.clear()
        if self.obj.Status:
            self.outcome.addItem(self.obj.Status)
        for line in list(self.obj.Faults) + list(self.obj.Summary):
            self.outcome.addItem(line)

    def _select_named(self, item):
        """Shows the element that a fault begins with."""
        found = re.match(r"(Vertex|Edge|Face|Solid) (\d+) at \(", item.text())
        if found is None or self.obj.Part is None:
            return
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.obj.Document.Name, self.obj.Part.Name, found[1] + found[2])

    def getStandardButtons(self):
        return int(QtGui.QDialogButtonBox.Close)

    def reject(self):
        """Close: a run that goes on is stopped."""
        if self.mesher is not None:
            self.timer.stop()
            self.mesher.cancel()
            try:
                self.mesher.finish()
            except OctetError:
                pass
        self._accept_words()
        FreeCADGui.getDocument(self.obj.Document.Name).resetEdit()
        self.obj.Document.recompute()
        return True
