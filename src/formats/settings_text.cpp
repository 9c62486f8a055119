// A document of one table.
#include "formats/settings_text.h"

#include "formats/toml/parameter_reader.h"

namespace umbral {

void read_settings(const std::string& source, const std::string& owner, const std::string& text,
                   const std::function<void(ParameterVisitor&)>& describe) {
  Diagnostics diagnostics;
  const toml_file::Context context{diagnostics, std::make_shared<const SourceText>(source, text)};
  const toml_file::Value root = toml_file::parse(context.source);
  toml_file::TableReader table(context, root.as<toml_file::Value::Table>(), owner, context.place(0, 0));
  toml_file::ParameterReader parameters(table, nullptr);
  describe(parameters);
  table.finish();
  diagnostics.throw_errors();
}

}  // namespace umbral
