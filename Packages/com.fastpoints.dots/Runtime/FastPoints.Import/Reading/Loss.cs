namespace FastPoints.Reading
{
    /// <summary>Something in a source that the target format cannot hold.</summary>
    internal readonly struct Loss
    {
        public readonly string What;

        /// <summary>The file that has it.</summary>
        public readonly string Where;
        public readonly string Why;

        public Loss(string what, string where, string why) => (What, Where, Why) = (what, where, why);

        public override string ToString() => Where + ": " + What + ": lost, since " + Why;
    }
}
