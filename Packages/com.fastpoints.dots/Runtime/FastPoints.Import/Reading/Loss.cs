namespace FastPoints.Reading
{
    /// <summary>Something in a source that the target format cannot hold.</summary>
    internal readonly struct Loss
    {
        public readonly string What;

        /// <summary>The file that has it.</summary>
        public readonly string Where;
        public readonly string Reason;

        public Loss(string what, string where, string reason) =>
            (What, Where, Reason) = (what, SourcePath.WithoutQuery(where), reason);

        public override string ToString() => Where + ": " + What + ": lost, since " + Reason;
    }
}
