// A form made from a message's type, with a control for each field, and what is typed in it.
function control(field) {
  if (field.control === "check") return make("input", { type: "checkbox", checked: field.value });
  const input = make("input", { type: "text", value: field.value, spellcheck: false, autocomplete: "off" });
  if (field.control === "whole" || field.control === "number") input.inputMode = "decimal";
  if (field.limit) input.maxLength = field.limit;
  if (field.control === "list") input.placeholder = "[1, 2, 3]";
  return input;
}

function form(fields, read) {
  return fields.map((field) => {
    const name = make("span", { className: "ck-field-name", textContent: field.name });
    const type = make("span", { className: "ck-dim ck-type", textContent: field.type });
    if (field.control === "group") {
      read[field.name] = {};
      return make("fieldset", {}, make("legend", {}, name, type), ...form(field.fields, read[field.name]));
    }
    const input = control(field);
    read[field.name] = () => (field.control === "check" ? input.checked : input.value);
    return make("label", { className: "ck-field" }, name, input, type);
  });
}

const values = (read) =>
  Object.fromEntries(Object.entries(read).map(([name, get]) => [name, typeof get === "function" ? get() : values(get)]));
