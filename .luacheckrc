-- Lua 5.4. Scripts get everything of ours by `local lsos = require 'lsos'`.
std = 'lua54'
max_line_length = 100
-- Wrong on purpose.
exclude_files = { 'tests/messages/**' }
-- Written from what is bound to Lua: one line a field, as the language server wants it.
files['lua/library.d.lua'] = { max_line_length = false }
