# SPDX-License-Identifier: BSD-3-Clause
# FreeCAD runs this at every start; without a window there is nothing to register.
