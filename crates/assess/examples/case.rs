use assess::verify::*;
fn main() {
    for a in std::env::args().skip(1) {
        let c = Case::read(std::path::Path::new(&a)).unwrap();
        let j = run(&c);
        for f in &j.findings { println!("{} {} {}", f.expect.quantity, f.found, f.met); } { ; }
        println!("{}", table(&[j]));
    }
}
