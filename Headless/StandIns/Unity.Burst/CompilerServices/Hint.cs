using System.Runtime.CompilerServices;

namespace Unity.Burst.CompilerServices
{
    /// <summary>Hints to Burst; the host's compiler has no use for them.</summary>
    public static class Hint
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static bool Likely(bool condition) => condition;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static bool Unlikely(bool condition) => condition;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Assume(bool condition)
        {
        }
    }
}
