//! stub
use super::*;
use ecow::EcoString;
pub type Str = EcoString;
#[derive(Clone, Debug, Default)]
pub enum Value { #[default] Unknown, None, Bool(bool), Int(i64), Float(f64), Str(Str), Scope(ScopeId) }
impl Value {
 pub fn type_name(&self)->&'static str {"x"}
 pub fn int(_n: impl Into<num_bigint::BigInt>) -> Self { Value::Int(0) }
 pub fn list_from(_i: impl IntoIterator<Item=Value>, _y: bool)->Self{Value::None}
 pub fn dict_from(_i: impl IntoIterator<Item=(Value,Value)>, _y: bool)->Self{Value::None}
}
#[derive(Clone, Debug)]
pub struct Budget { pub steps: u64, pub bytes: u64, pub depth: u32 }
impl Budget { pub fn new(steps:u64, bytes:u64, depth:u32)->Self{Self{steps,bytes,depth}} }
pub fn evaluate(e:&ast::Expr, host:&mut dyn Host, _b:&mut Budget)->Result<Value,EvalError>{
  match &e.kind { ast::ExprKind::Const(ast::Const::Int(i)) => Ok(Value::Int(*i)), ast::ExprKind::Const(ast::Const::Str(i)) => Ok(Value::Str(i.clone())), ast::ExprKind::Name(n)=>{ host.undefined(n, e.range); Ok(Value::Unknown)}, _=>Ok(Value::Unknown)}
}
pub mod display { use super::*; pub fn to_str(v:&Value)->Option<Str>{ match v { Value::Str(s)=>Some(s.clone()), Value::Int(i)=>Some(i.to_string().into()), Value::Float(i)=>Some(format!("{i:?}").into()), Value::Bool(b)=>Some(if *b {"True"}else{"False"}.into()), _=>None } } pub fn repr(v:&Value)->Option<Str>{to_str(v)} }
pub mod literal { use super::*; pub fn from_text(t:&str)->Value{ if let Ok(i)=t.parse(){return Value::Int(i)} if let Ok(f)=t.parse(){return Value::Float(f)} match t {"true"|"True"=>Value::Bool(true),"false"|"False"=>Value::Bool(false),_=>Value::Str(t.into())} } pub fn boolean(v:&Value)->Option<bool>{ match v { Value::Bool(b)=>Some(*b), Value::Int(i)=>Some(*i!=0), Value::Str(s)=>match s.as_str(){"true"=>Some(true),"false"=>Some(false),_=>None}, _=>Some(false)} } pub fn is_global_symbol(n:&str)->bool{n=="pi"} }
pub fn truth(_v:&Value)->Option<bool>{None}
pub fn global_symbol(_n:&str)->Option<Value>{None}
pub fn math_symbol(_n:&str)->Option<Value>{None}
pub fn python_builtin(_n:&str)->Option<Value>{None}
pub fn parse_int(t:&str)->Option<Value>{t.parse().ok().map(Value::Int)}
pub fn parse_float(t:&str)->Option<Value>{t.parse().ok().map(Value::Float)}
