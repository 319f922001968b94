/* Stands in for Windows' bcryptprimitives.dll where wine has none (before 9.0): Rust's standard library asks it for
   the random keys of its hash maps. For the test under wine alone. */
__declspec(dllexport) int ProcessPrng(unsigned char *bytes, unsigned long long count)
{
    while (count > 0)
        bytes[--count] = (unsigned char)(37 * count);
    return 1;
}
