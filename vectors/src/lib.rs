mod case; mod flags; mod json; mod model; mod template; mod text;
