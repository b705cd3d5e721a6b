#include <isoloop/isoloop.h>

int main() { return isoloop::shape_names().empty() ? 1 : 0; }
