// The sheet of joint functions: buttons that copy the text beside them.

import { copyButtons } from "../panels/copy.ts";
import { found } from "../panels/found.ts";

copyButtons(
  (button) => found("code", button.parentElement ?? document).textContent ?? "",
  (button) => button.dataset["done"] ?? "",
);
