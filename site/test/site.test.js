/** The site, made once for all that is asked of it. */

import { inBrowser } from "./browser.js";
import { ofContents } from "./contents.js";
import { ofLinks } from "./links.js";
import { make } from "./made.js";

const site = make();
ofLinks(site);
ofContents(site);
inBrowser(site);
