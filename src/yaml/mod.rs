//! stub
pub struct Node { pub kind: Kind }
pub enum Kind { Null, Bool(bool), Int(i64), Float(f64), Str(String), List(Vec<Node>), Map(Vec<(Node,Node)>) , X}
pub struct YamlError { pub message: String }
pub fn load(_t:&str,_n:&str)->Result<Node,YamlError>{ Ok(Node{kind:Kind::Null}) }
