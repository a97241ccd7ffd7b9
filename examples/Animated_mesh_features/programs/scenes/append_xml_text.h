// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_APPEND_XML_TEXT_H
#define PROGRAMS_SCENES_APPEND_XML_TEXT_H

#include <string>

namespace Programs {

// The text as a reader of the XML finds it. Names may be any bytes; what is not UTF-8, and the control characters that XML
// cannot hold, become U+FFFD.
std::string xml_characters(const std::string& text);

// xml_characters(text) for the content of an XML element or an attribute in double quotes.
void append_xml_text(std::string& xml, const std::string& text);

} // namespace Programs

#endif // PROGRAMS_SCENES_APPEND_XML_TEXT_H
