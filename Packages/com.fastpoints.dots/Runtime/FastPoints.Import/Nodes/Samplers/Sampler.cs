namespace FastPoints.Nodes
{
    /// <summary>How the points of a cube are chosen that represent the others.</summary>
    public enum Sampler
    {
        /// <summary>One random point of each cell of a grid.</summary>
        Random,

        /// <summary>Blue noise: no two points of a chunk are nearer than the spacing; off its faces no other would fit.</summary>
        Poisson,

        /// <summary>Like <see cref="Poisson"/>, with colour and intensity averaged over the points that each point represents, in
        /// planes of their own.</summary>
        Average,
    }
}
