namespace FastPoints.Points
{
    /// <summary>The axis of a cloud that points up.</summary>
    public enum UpAxis
    {
        X = 0,
        Y = 1,
        Z = 2,
    }
}
