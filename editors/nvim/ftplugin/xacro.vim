" Xacro is XML: comments, matching tags and the like are those of XML.
if exists('b:did_ftplugin')
  finish
endif
runtime! ftplugin/xml.vim
let b:did_ftplugin = 1
setlocal commentstring=<!--\ %s\ -->
" gf and include search: relative names, as xacro reads them
setlocal suffixesadd+=.xacro,.urdf
lua require('xacro.indent').detect(0)
