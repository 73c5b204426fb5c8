namespace FastPoints.Editor
{
    /// <summary>Where an <see cref="ImportRequest"/> stands. One that was imported is no longer in the queue.</summary>
    public enum ImportState
    {
        Waiting,
        Running,
        /// <summary>By the user: others go before it.</summary>
        Paused,
        /// <summary>Until the user tries again or takes it out.</summary>
        Failed,
    }
}
