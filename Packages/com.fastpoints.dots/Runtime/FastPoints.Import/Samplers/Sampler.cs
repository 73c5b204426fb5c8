namespace FastPoints.Samplers
{
    /// <summary>How the points of a cube are chosen that represent the others.</summary>
    public enum Sampler
    {
        /// <summary>One random point of each cell of a grid.</summary>
        Random,

        /// <summary>Blue noise: no two points are nearer than the spacing, and no further point would fit between.</summary>
        Poisson,

        /// <summary>Like <see cref="Poisson"/>, with colour and intensity averaged over the points that each point represents, in
        /// planes of their own.</summary>
        Average,
    }
}
