" XML, with expressions and substitutions inside values. The server's semantic tokens refine this.
if exists('b:current_syntax')
  finish
endif
runtime! syntax/xml.vim
unlet! b:current_syntax

syntax match xacroDirective /\<xacro:\w\+\>/ contained containedin=xmlTagName,xmlEndTag
syntax region xacroExpression matchgroup=xacroDelimiter start=/\${/ end=/}/ contained oneline
      \ containedin=xmlString contains=xacroNumber,xacroText,xacroFunction
syntax region xacroSubstitution matchgroup=xacroDelimiter start=/\$(/ end=/)/ contained oneline
      \ containedin=xmlString,xacroText contains=xacroCommand
syntax match xacroNumber /\<\d\+\(\.\d*\)\?\([eE][-+]\?\d\+\)\?\>/ contained
syntax match xacroFunction /\<\h\w*\ze\s*(/ contained
syntax region xacroText start=/'/ end=/'/ contained oneline
syntax keyword xacroCommand arg find env optenv dirname eval cwd anon contained

highlight default link xacroDirective Keyword
highlight default link xacroDelimiter Special
highlight default link xacroExpression Identifier
highlight default link xacroSubstitution Identifier
highlight default link xacroNumber Number
highlight default link xacroFunction Function
highlight default link xacroText String
highlight default link xacroCommand Keyword

let b:current_syntax = 'xacro'
