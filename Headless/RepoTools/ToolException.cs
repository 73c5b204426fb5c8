namespace FastPoints.RepoTools
{
    /// <summary>A tool cannot do its work; the message says what to do about it.</summary>
    public sealed class ToolException : Exception
    {
        public ToolException(string message) : base(message)
        {
        }
    }
}
