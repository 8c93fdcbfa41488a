runtime! ftplugin/xacro.vim
