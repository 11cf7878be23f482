-- Lua 5.4. Scripts get everything of ours by `local lsos = require 'lsos'`.
std = 'lua54'
max_line_length = 100
-- Wrong on purpose.
exclude_files = { 'tests/messages/**' }
