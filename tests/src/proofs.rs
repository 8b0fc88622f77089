//! The reader of the core's proofs: which properties there are, which functions they name, and which
//! functions have arithmetic.

use crate::{Failure, layers::Source};
use std::collections::BTreeSet;
use syn::{
    Attribute, Block, Expr, ExprBinary, ExprUnary, Ident, ItemFn, ItemImpl, ItemMacro, ItemMod, Lit, Meta,
    Token, TraitItemFn, UnOp, bracketed, parenthesized,
    parse::{Parse, ParseStream},
    visit::{self, Visit},
};

/// One property of a `proofs` module, as `prove!` has it.
#[derive(Clone, Debug)]
pub struct Property {
    /// The module below `src` and the property's name, as a prover shows them.
    pub path: String,
    /// What holds.
    pub doc: String,
    /// The inputs as written, with their ranges.
    pub inputs: String,
    /// The functions whose arithmetic it executes.
    pub proves: Vec<String>,
    /// How often it assumes something beyond its ranges.
    pub assumptions: usize,
}

/// A function with arithmetic in it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Function {
    /// The layer it is in.
    pub layer: String,
    /// `Type::method`, or the name alone.
    pub name: String,
}

/// Whether a module holds properties and not what they are about.
fn is_proofs(module: &[String]) -> bool {
    module.iter().any(|part| part == "proofs" || part == "proof")
}

/// All properties.
pub fn properties(sources: &[Source]) -> Result<Vec<Property>, Failure> {
    let mut all = Vec::new();
    for source in sources.iter().filter(|source| is_proofs(&source.module)) {
        let mut found = Macros { module: source.module.join("::"), all: Vec::new(), error: None };
        found.visit_file(&syn::parse_file(&source.text)?);
        if let Some(error) = found.error {
            return Err(Failure(format!("{}: {error}", source.module.join("/"))));
        }
        all.extend(found.all);
    }
    Ok(all)
}

/// All functions with arithmetic that can overflow, lose bits or be out of range: operators, casts, indexing.
/// Constants are left out: compilers evaluate them.
pub fn arithmetic(sources: &[Source]) -> Result<Vec<Function>, Failure> {
    let mut all = BTreeSet::new();
    for source in sources.iter().filter(|source| !is_proofs(&source.module) && source.module.len() > 1) {
        let mut found = Functions { layer: source.module[0].clone(), owner: None, all: &mut all };
        found.visit_file(&syn::parse_file(&source.text)?);
    }
    Ok(all.into_iter().collect())
}

/// The functions that no property names. A property speaks of its own layer first: a name that several layers
/// have is its own layer's.
pub fn unproved(functions: &[Function], properties: &[Property]) -> Vec<Function> {
    let named: BTreeSet<(&str, &str)> = properties
        .iter()
        .flat_map(|property| {
            let layer = property.path.split("::").next().unwrap_or_default();
            property.proves.iter().map(move |name| (layer, name.as_str()))
        })
        .collect();
    let layers = |name: &str| functions.iter().filter(|function| function.name == name).count();
    let is_named = |function: &&Function| {
        named.contains(&(&function.layer, &function.name))
            || layers(&function.name) == 1 && named.iter().any(|(_, name)| *name == function.name)
    };
    functions.iter().filter(|function| !is_named(function)).cloned().collect()
}

/// The names in brackets that name no function.
pub fn unknown(sources: &[Source], properties: &[Property]) -> Result<Vec<String>, Failure> {
    let mut all = String::new();
    for source in sources.iter().filter(|source| !is_proofs(&source.module)) {
        all.push_str(&source.text);
    }
    let declared = |name: &str| {
        let name = name.rsplit("::").next().unwrap_or(name);
        all.contains(&format!("fn {name}(")) || all.contains(&format!("fn {name}<"))
            // Made by a macro, which is given the name.
            || all.contains(&format!("!({name},"))
    };
    let names: BTreeSet<&String> = properties.iter().flat_map(|property| &property.proves).collect();
    Ok(names.into_iter().filter(|name| !declared(name)).cloned().collect())
}

struct Macros {
    module: String,
    all: Vec<Property>,
    error: Option<syn::Error>,
}

impl<'ast> Visit<'ast> for Macros {
    fn visit_item_macro(&mut self, item: &'ast ItemMacro) {
        if !item.mac.path.is_ident("prove") {
            return;
        }
        match item.mac.parse_body::<Statements>() {
            Ok(statements) => self.all.extend(statements.0.into_iter().map(|property| Property {
                path: format!("{}::{}", self.module, property.path),
                ..property
            })),
            Err(error) => self.error = Some(error),
        }
    }
}

struct Statements(Vec<Property>);

impl Parse for Statements {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let mut all = Vec::new();
        while !input.is_empty() {
            let doc = doc(&Attribute::parse_outer(input)?);
            let brackets;
            bracketed!(brackets in input);
            let names: proc_macro2::TokenStream = brackets.parse()?;
            let proves = names.to_string().replace(' ', "");
            let proves = proves.split(',').filter(|name| !name.is_empty()).map(str::to_owned).collect();
            input.parse::<Token![fn]>()?;
            let name: Ident = input.parse()?;
            let inputs;
            parenthesized!(inputs in input);
            let inputs: proc_macro2::TokenStream = inputs.parse()?;
            let body: Block = input.parse()?;
            let mut assumptions = Assumptions(0);
            assumptions.visit_block(&body);
            all.push(Property {
                path: name.to_string(),
                doc,
                inputs: inputs.to_string(),
                proves,
                assumptions: assumptions.0,
            });
        }
        Ok(Self(all))
    }
}

fn doc(attributes: &[Attribute]) -> String {
    let lines = attributes.iter().filter_map(|attribute| match &attribute.meta {
        Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
            Expr::Lit(literal) => match &literal.lit {
                Lit::Str(text) => Some(text.value().trim().to_owned()),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    });
    lines.collect::<Vec<_>>().join(" ")
}

struct Assumptions(usize);

impl<'ast> Visit<'ast> for Assumptions {
    fn visit_macro(&mut self, found: &'ast syn::Macro) {
        self.0 += usize::from(found.path.is_ident("assume"));
    }
}

struct Functions<'a> {
    layer: String,
    owner: Option<String>,
    all: &'a mut BTreeSet<Function>,
}

impl Functions<'_> {
    fn take(&mut self, name: &Ident, block: &Block) {
        let mut found = Arithmetic(false);
        found.visit_block(block);
        if found.0 {
            let name = match &self.owner {
                Some(owner) => format!("{owner}::{name}"),
                None => name.to_string(),
            };
            self.all.insert(Function { layer: self.layer.clone(), name });
        }
    }
}

/// The name of a type without its parameters.
fn type_name(item: &syn::Type) -> String {
    match item {
        syn::Type::Path(path) => {
            path.path.segments.last().map_or_else(String::new, |last| last.ident.to_string())
        }
        syn::Type::Slice(_) => "slice".to_owned(),
        syn::Type::Tuple(_) => "tuple".to_owned(),
        syn::Type::Reference(reference) => type_name(&reference.elem),
        _ => String::new(),
    }
}

impl<'ast> Visit<'ast> for Functions<'_> {
    fn visit_item_mod(&mut self, item: &'ast ItemMod) {
        let owner = self.owner.take();
        visit::visit_item_mod(self, item);
        self.owner = owner;
    }

    fn visit_item_impl(&mut self, item: &'ast ItemImpl) {
        let owner = self.owner.replace(type_name(&item.self_ty));
        visit::visit_item_impl(self, item);
        self.owner = owner;
    }

    fn visit_item_trait(&mut self, item: &'ast syn::ItemTrait) {
        let owner = self.owner.replace(item.ident.to_string());
        visit::visit_item_trait(self, item);
        self.owner = owner;
    }

    fn visit_item_fn(&mut self, item: &'ast ItemFn) {
        self.take(&item.sig.ident, &item.block);
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.take(&item.sig.ident, &item.block);
    }

    fn visit_trait_item_fn(&mut self, item: &'ast TraitItemFn) {
        if let Some(block) = &item.default {
            self.take(&item.sig.ident, block);
        }
    }
}

struct Arithmetic(bool);

impl<'ast> Visit<'ast> for Arithmetic {
    fn visit_expr_binary(&mut self, expression: &'ast ExprBinary) {
        use syn::BinOp::*;
        self.0 |= matches!(
            expression.op,
            Add(_)
                | Sub(_)
                | Mul(_)
                | Div(_)
                | Rem(_)
                | Shl(_)
                | Shr(_)
                | AddAssign(_)
                | SubAssign(_)
                | MulAssign(_)
                | DivAssign(_)
                | RemAssign(_)
                | ShlAssign(_)
                | ShrAssign(_)
        );
        visit::visit_expr_binary(self, expression);
    }

    fn visit_expr_unary(&mut self, expression: &'ast ExprUnary) {
        self.0 |= matches!(expression.op, UnOp::Neg(_)) && !matches!(*expression.expr, Expr::Lit(_));
        visit::visit_expr_unary(self, expression);
    }

    fn visit_expr_cast(&mut self, expression: &'ast syn::ExprCast) {
        self.0 = true;
        visit::visit_expr_cast(self, expression);
    }

    fn visit_expr_index(&mut self, expression: &'ast syn::ExprIndex) {
        self.0 = true;
        visit::visit_expr_index(self, expression);
    }

    // Constants are evaluated by the compiler.
    fn visit_item_const(&mut self, _: &'ast syn::ItemConst) {}
}
