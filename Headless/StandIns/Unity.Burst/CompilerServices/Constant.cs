namespace Unity.Burst.CompilerServices
{
    public static class Constant
    {
        /// <summary>What managed code answers: nothing is known to be constant.</summary>
        public static bool IsConstantExpression<T>(T t) where T : unmanaged => false;

        public static unsafe bool IsConstantExpression(void* t) => false;
    }
}
