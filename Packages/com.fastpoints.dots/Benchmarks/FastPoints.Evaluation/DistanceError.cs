namespace FastPoints.Evaluation
{
    /// <summary>
    /// How far a sample is from the full cloud, point to point, both ways, in units of a length that the caller states. Of
    /// the two directions the larger counts; from the sample to the cloud it is 0, since a sample is a part of the cloud,
    /// so that these are the distances from points of the full cloud to the nearest one of the sample.
    /// </summary>
    /// <remarks>
    /// The larger of both directions: Tian, Ochimizu, Feng, Cohen, Vetro, "Geometric distortion metrics for point cloud
    /// compression", 2017 (D1). Ranked: Huttenlocher, Klanderman, Rucklidge, "Comparing images using the Hausdorff distance",
    /// 1993. Infinite for an empty sample.
    /// </remarks>
    public struct DistanceError
    {
        /// <summary>Points of the full cloud that were asked, of a uniform choice.</summary>
        public int Queries;

        /// <summary>Root of the mean square.</summary>
        public double Rms;

        /// <summary>The distance that 95 (99) of 100 points do not exceed: the nearest rank, of place ceil(0.95 n).</summary>
        public double Ranked95;
        public double Ranked99;
    }
}
