// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/append_xml_text.h"

#include <nlohmann/json.hpp>

namespace Programs {

namespace {

// JSON must be UTF-8, too, and its library knows how.
std::string valid_utf8(const std::string& text)
{
  typedef nlohmann::json Json;
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

} // namespace

std::string xml_characters(const std::string& text)
{
  std::string result;
  for (const char c : valid_utf8(text)) {
    const bool is_control = static_cast<unsigned char>(c) < ' ' && c != '\t' && c != '\n';
    if (is_control)
      result += "\xef\xbf\xbd";
    else
      result += c;
  }
  return result;
}

void append_xml_text(std::string& xml, const std::string& text)
{
  for (const char c : xml_characters(text)) {
    if (c == '&')
      xml += "&amp;";
    else if (c == '<')
      xml += "&lt;";
    else if (c == '>')
      xml += "&gt;";
    else if (c == '"')
      xml += "&quot;";
    else
      xml += c;
  }
}

} // namespace Programs
