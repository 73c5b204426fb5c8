namespace FastPoints.Samplers
{
    /// <summary>Who decides which points of a cube stand for the others.</summary>
    public enum Sampler
    {
        /// <summary>One point of each cell of a grid, by chance.</summary>
        Random,

        /// <summary>Blue noise: no two points nearer than the spacing, and none missing that would fit between.</summary>
        Poisson,

        /// <summary>As <see cref="Poisson"/>, with colour and intensity averaged over the points that a point stands for, in
        /// planes of their own.</summary>
        Average,
    }
}
