namespace FastPoints.Evaluation
{
    /// <remarks>What chance would give is for a simple random sample of as many points, drawn without replacement: the share
    /// taken of a cell with f points then has the variance p (1 - p) / f, where p is the share taken of all.</remarks>
    public struct CellError
    {
        public const int MinPointsOfBlock = 100;
        public const int MinRegion = 1000;

        public long PointsOfCloud;
        public long PointsOfSample;

        /// <summary>Cells that the full cloud occupies, of an edge of a 64th, a 128th, a 256th and a 512th of the
        /// grid's.</summary>
        public int Occupied64;
        public int Occupied128;
        public int Occupied256;
        public int Occupied512;

        /// <summary>Share of these without a point of the sample; 0 if there are none.</summary>
        public double Uncovered64;
        public double Uncovered128;
        public double Uncovered256;
        public double Uncovered512;

        /// <summary>Coefficient of variation of the share sampled: the root of the mean, over the 64th cells with at least
        /// <see cref="MinPointsOfBlock"/> points, of the squares of (share taken of the cell / share taken of all - 1). NaN
        /// where there is no such cell, or no point sampled.</summary>
        public double Variation;

        /// <summary>What chance would give for <see cref="Variation"/>.</summary>
        public double VariationByChance;

        /// <summary>The largest |share taken of a region / share taken of all - 1| over the regions (an eighth of the grid's
        /// edge) with at least one in <see cref="MinRegion"/> of the full cloud's points; 1 for a region that was missed. NaN
        /// without points.</summary>
        public double Bias;

        /// <summary>What chance would exceed in one sample of two for <see cref="Bias"/>: the median of the largest
        /// deviation, with the regions taken for independent and normal.</summary>
        public double BiasByChance;
    }
}
