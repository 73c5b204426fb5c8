namespace StandIns.Collections;

static class RoundedUp
{
    internal static long ToPowerOfTwo(long value)
    {
        long power = 1;
        while (power < value)
            power <<= 1;
        return power;
    }
}
