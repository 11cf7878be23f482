#include "edit/kml_dom.h"

#include <fmt/format.h>
#include <libxml/parser.h>
#include <libxml/tree.h>
#include <libxml/xmlsave.h>

#include <array>

#include "base/error.h"
#include "base/replaced.h"
#include "base/text.h"

namespace lsos {

namespace {

const xmlChar* xml(const char* text) { return reinterpret_cast<const xmlChar*>(text); }
std::string_view view(const xmlChar* text) {
  return text == nullptr ? std::string_view() : reinterpret_cast<const char*>(text);
}

std::string taken(xmlChar* text) {
  std::string copy(view(text));
  xmlFree(text);
  return copy;
}

bool is_text(const xmlNode* node) {
  return node->type == XML_TEXT_NODE || node->type == XML_CDATA_SECTION_NODE;
}

bool is_blank(const xmlNode* node) {
  return node != nullptr && node->type == XML_TEXT_NODE && trimmed(view(node->content)).empty();
}

// Text and CDATA directly in the element, with the blanks around it.
std::string whole_text(KmlElement element) {
  std::string text;
  for (const xmlNode* node = element->children; node != nullptr; node = node->next) {
    if (is_text(node)) text += view(node->content);
  }
  return text;
}

void drop(xmlNode* node) {
  xmlUnlinkNode(node);
  xmlFreeNode(node);
}

struct FreeContext {
  void operator()(xmlParserCtxt* context) const { xmlFreeParserCtxt(context); }
};
struct FreeBuffer {
  void operator()(xmlBuffer* buffer) const { xmlBufferFree(buffer); }
};
using Buffer = std::unique_ptr<xmlBuffer, FreeBuffer>;

std::string saved(xmlDoc* document, xmlNode* node, int options) {
  const Buffer buffer(xmlBufferCreate());
  xmlSaveCtxt* save = xmlSaveToBuffer(buffer.get(), "UTF-8", options | XML_SAVE_AS_XML);
  LSOS_ASSERT(save != nullptr);
  if (node == nullptr) {
    xmlSaveDoc(save, document);
  } else {
    xmlSaveTree(save, node);
  }
  xmlSaveClose(save);
  return std::string(view(xmlBufferContent(buffer.get())));
}

void collect_placemarks(KmlElement element, std::vector<KmlElement>& found) {
  constexpr std::array<std::string_view, 3> containers{"kml", "Document", "Folder"};
  const std::string_view name = local_name(element);
  if (name == "Placemark") found.push_back(element);
  if (std::find(containers.begin(), containers.end(), name) == containers.end()) return;
  for (const KmlElement each : children(element)) collect_placemarks(each, found);
}

// The namespace of that name by which `parent` knows it: by the prefix asked for, else by that of
// the parent, else as the default one. nullptr when by none of these.
xmlNs* known_namespace(KmlElement parent, const xmlNs* wanted, const xmlChar* prefix) {
  const xmlChar* parents = parent->ns == nullptr ? nullptr : parent->ns->prefix;
  for (const xmlChar* each : {prefix, parents, static_cast<const xmlChar*>(nullptr)}) {
    xmlNs* found = xmlSearchNs(parent->doc, parent, each);
    if (found != nullptr && xmlStrEqual(found->href, wanted->href)) return found;
  }
  return nullptr;
}

// Gives a copy and all in it the namespaces as their surroundings name them: where one has several
// prefixes, as Google Earth declares two for KML, libxml2 takes any of them, and readers know one.
void name_as_around(xmlNode* copy, const xmlNode* original, KmlElement parent) {
  if (copy->nsDef != nullptr) return;  // its prefixes are its own
  if (copy->ns != nullptr) {
    const bool is_same_document = original->doc == parent->doc;
    const xmlChar* prefix =
        is_same_document && original->ns != nullptr ? original->ns->prefix : nullptr;
    if (xmlNs* found = known_namespace(parent, copy->ns, prefix)) copy->ns = found;
  }
  const xmlNode* from = original->children;
  for (xmlNode* node = copy->children; node != nullptr && from != nullptr; node = node->next) {
    if (node->type == XML_ELEMENT_NODE) name_as_around(node, from, parent);
    from = from->next;
  }
}

// A copy within the namespaces that are known in `parent`.
xmlNode* copied(KmlElement element, KmlElement parent) {
  xmlNode* copy = nullptr;
  const int failed =
      xmlDOMWrapCloneNode(nullptr, element->doc, element, &copy, parent->doc, parent, 1, 0);
  LSOS_ASSERT(failed == 0 && copy != nullptr);
  name_as_around(copy, element, parent);
  if (element->doc == parent->doc) xmlUnsetProp(copy, xml("id"));
  return copy;
}

// A new element in the namespace of its future parent.
xmlNode* created(KmlElement parent, const char* name, std::string_view text) {
  xmlNode* element = xmlNewDocNode(parent->doc, parent->ns, xml(name), nullptr);
  if (!text.empty()) {
    xmlAddChild(element, xmlNewDocTextLen(parent->doc, xml(std::string(text).c_str()),
                                          static_cast<int>(text.size())));
  }
  return element;
}

// The first child that KML's schema wants behind those of that name; nullptr when there is none.
KmlElement part_behind(KmlElement feature, std::string_view name) {
  // OGC 07-147r2, 9.1: the parts of a Feature in their order.
  constexpr std::array<std::string_view, 20> order{
      "name",        "visibility",     "open",        "author",    "link",
      "address",     "AddressDetails", "phoneNumber", "Snippet",   "snippet",
      "description", "LookAt",         "Camera",      "TimeStamp", "TimeSpan",
      "styleUrl",    "Style",          "StyleMap",    "Region",    "ExtendedData"};
  const auto rank = [&](std::string_view part) {
    return std::find(order.begin(), order.end(), part) - order.begin();
  };
  for (const KmlElement each : children(feature)) {
    if (rank(local_name(each)) > rank(name)) return each;
  }
  return nullptr;
}

}  // namespace

void KmlDom::Free::operator()(_xmlDoc* document) const { xmlFreeDoc(document); }

KmlDom::KmlDom(const std::string& utf8, const std::string& file)
    : has_declaration_(utf8.starts_with("<?xml")) {
  const std::size_t line_end = utf8.find('\n');
  has_crlf_ = line_end != std::string::npos && line_end > 0 && utf8[line_end - 1] == '\r';
  const std::unique_ptr<xmlParserCtxt, FreeContext> context(xmlNewParserCtxt());
  LSOS_ASSERT(context != nullptr);
  // Sizes are limited by the plan's reader. Without XML_PARSE_NOENT and XML_PARSE_DTDLOAD nothing
  // is expanded or loaded.
  constexpr int options =
      XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_HUGE;
  document_.reset(xmlCtxtReadMemory(context.get(), utf8.data(), static_cast<int>(utf8.size()),
                                    nullptr, "UTF-8", options));
  if (document_ != nullptr && context->wellFormed != 0) return;
  const xmlError& error = context->lastError;
  const std::string_view what = error.message == nullptr ? "it is no XML" : error.message;
  throw InputError({file, error.line},
                   fmt::format("cannot be edited, though it can be read: {}", trimmed(what)));
}

KmlDom::~KmlDom() = default;

std::string KmlDom::text() const {
  const std::string text = saved(document_.get(), nullptr, has_declaration_ ? 0 : XML_SAVE_NO_DECL);
  return has_crlf_ ? replaced(text, "\n", "\r\n") : text;
}

KmlElement KmlDom::root() const { return xmlDocGetRootElement(document_.get()); }

std::vector<KmlElement> KmlDom::placemarks() const {
  std::vector<KmlElement> found;
  collect_placemarks(root(), found);
  return found;
}

std::vector<KmlElement> KmlDom::shared(std::string_view name) const {
  std::vector<KmlElement> found;
  const auto collect = [&](const auto& again, KmlElement parent) -> void {
    for (const KmlElement each : children(parent)) {
      if (local_name(each) == name) found.push_back(each);
      if (local_name(each) == "Document") again(again, each);
    }
  };
  collect(collect, root());
  return found;
}

KmlElement KmlDom::copy_behind(KmlElement element, KmlElement after) {
  xmlNode* copy = copied(element, after->parent);
  const xmlNode* blanks = after->prev;
  xmlAddNextSibling(after, copy);
  if (is_blank(blanks)) xmlAddNextSibling(after, xmlNewDocText(document_.get(), blanks->content));
  return copy;
}

KmlElement KmlDom::container() const {
  const KmlElement document = child(root(), "Document");
  return document == nullptr ? root() : document;
}

KmlElement KmlDom::copy_before(KmlElement element, KmlElement before) {
  xmlNode* copy = copied(element, before->parent);
  const xmlNode* blanks = before->prev;
  xmlAddPrevSibling(before, copy);
  if (is_blank(blanks)) xmlAddNextSibling(copy, xmlNewDocText(document_.get(), blanks->content));
  return copy;
}

KmlElement KmlDom::copy_into(KmlElement element, KmlElement parent) {
  xmlNode* last = xmlGetLastChild(parent);
  const bool has_end = is_blank(last);
  const xmlNode* first = parent->children;
  xmlNode* copy = copied(element, parent);
  if (!has_end) {
    const xmlNode* blanks = element->prev;
    if (is_blank(blanks)) xmlAddChild(parent, xmlNewDocText(document_.get(), blanks->content));
    return xmlAddChild(parent, copy);
  }
  xmlAddPrevSibling(last, copy);
  if (first != last && is_blank(first)) {
    xmlAddPrevSibling(copy, xmlNewDocText(document_.get(), first->content));
  }
  return copy;
}

KmlElement KmlDom::add_first(KmlElement parent, const char* name, std::string_view text) {
  xmlNode* first = parent->children;
  LSOS_ASSERT(first != nullptr);
  xmlNode* added = xmlAddPrevSibling(first, created(parent, name, text));
  if (is_blank(first)) xmlAddPrevSibling(added, xmlNewDocText(document_.get(), first->content));
  return added;
}

KmlElement KmlDom::add(KmlElement parent, const char* name, std::string_view text) {
  xmlNode* added = created(parent, name, text);
  xmlNode* last = xmlGetLastChild(parent);
  if (!is_blank(last)) return xmlAddChild(parent, added);
  const xmlNode* first = parent->children;
  xmlAddPrevSibling(last, added);
  if (first != last && is_blank(first)) {
    xmlAddPrevSibling(added, xmlNewDocText(document_.get(), first->content));
  }
  return added;
}

KmlElement KmlDom::add_feature_part(KmlElement feature, const char* name, std::string_view text) {
  const KmlElement next = part_behind(feature, name);
  if (next == nullptr) return add(feature, name, text);
  const xmlNode* blanks = next->prev;
  xmlNode* added = xmlAddPrevSibling(next, created(feature, name, text));
  if (is_blank(blanks)) xmlAddNextSibling(added, xmlNewDocText(document_.get(), blanks->content));
  return added;
}

KmlElement KmlDom::copy_as_feature_part(KmlElement element, KmlElement feature) {
  const KmlElement next = part_behind(feature, local_name(element));
  return next == nullptr ? copy_into(element, feature) : copy_before(element, next);
}

void KmlDom::remove(KmlElement element) {
  if (is_blank(element->prev)) drop(element->prev);
  drop(element);
}

std::string_view local_name(KmlElement element) {
  // A prefix that is not declared is part of the name.
  const std::string_view name = view(element->name);
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::vector<KmlElement> children(KmlElement parent) {
  std::vector<KmlElement> found;
  for (xmlNode* node = parent->children; node != nullptr; node = node->next) {
    if (node->type == XML_ELEMENT_NODE) found.push_back(node);
  }
  return found;
}

KmlElement child(KmlElement parent, std::string_view name) {
  for (const KmlElement each : children(parent)) {
    if (local_name(each) == name) return each;
  }
  return nullptr;
}

KmlElement parent_of(KmlElement element) { return element->parent; }

std::string attribute(KmlElement element, const char* name) {
  return std::string(trimmed(taken(xmlGetNoNsProp(element, xml(name)))));
}

void set_attribute(KmlElement element, const char* name, const std::string& value) {
  xmlSetProp(element, xml(name), xml(value.c_str()));
}

std::string text_of(KmlElement element) { return std::string(trimmed(whole_text(element))); }

void set_text(KmlElement element, const std::string& text) {
  const std::string whole = whole_text(element);
  const std::string old(trimmed(whole));
  const std::size_t at = old.empty() ? 0 : whole.find(old);
  const std::string changed = whole.substr(0, at) + text + whole.substr(at + old.size());
  xmlNode* next = nullptr;
  for (xmlNode* node = element->children; node != nullptr; node = next) {
    next = node->next;
    if (is_text(node)) drop(node);
  }
  xmlNode* added = xmlNewDocText(element->doc, xml(changed.c_str()));
  if (element->children == nullptr) {
    xmlAddChild(element, added);
  } else {
    xmlAddPrevSibling(element->children, added);
  }
}

void append_text(KmlElement element, const std::string& text) {
  xmlAddChild(element, xmlNewDocText(element->doc, xml(text.c_str())));
}

bool erase_text(KmlElement element, std::string_view begin, std::string_view end) {
  bool was_there = false;
  for (xmlNode* node = element->children; node != nullptr; node = node->next) {
    if (!is_text(node)) continue;
    std::string text(view(node->content));
    const std::size_t from = text.find(begin), to = text.find(end, from);
    if (from == std::string::npos || to == std::string::npos) continue;
    text.erase(from, to + end.size() - from);
    xmlNodeSetContent(node, xml(text.c_str()));
    was_there = true;
  }
  return was_there;
}

void for_each_element(KmlElement parent, const std::function<void(KmlElement)>& visit) {
  for (const KmlElement each : children(parent)) {
    visit(each);
    for_each_element(each, visit);
  }
}

std::vector<KmlElement> coordinates_of(KmlElement placemark) {
  std::vector<KmlElement> found;
  for_each_element(placemark, [&](KmlElement each) {
    if (local_name(each) == "coordinates") found.push_back(each);
  });
  return found;
}

std::string xml_of(KmlElement element) {
  return saved(element->doc, element, XML_SAVE_NO_DECL | XML_SAVE_FORMAT);
}

}  // namespace lsos
