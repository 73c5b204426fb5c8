using Unity.Mathematics;

namespace FastPoints
{
    /// <summary>Sums over points, of offsets from one of them.</summary>
    internal struct OffsetSums
    {
        public int Count;
        public float3 Offset;
        public float3 Squares; // Of products: xx, yy, zz, and xy, xz, yz.
        public float3 Mixed;
    }

    /// <summary>The plane through points with the least squares of distances: across it is the eigenvector of their covariance
    /// that has the smallest eigenvalue.</summary>
    internal static class PlaneFit
    {
        const int MaxSteps = 24;

        /// <summary>Points whose second variance is a smaller share of the total lie on a line, or at one place: a hundredth as
        /// wide as long. Those whose two smaller ones differ by less have no direction across.</summary>
        const double MinShare = 1e-4;

        const double MinDifference = 1e-6;

        /// <summary>False for points on a line, at one place, or as far spread in all directions.</summary>
        /// <remarks>Sums are of offsets no longer than the neighbourhood: float's rounding turns the plane by a
        /// millionth.</remarks>
        public static bool TryFit(in OffsetSums sums, out float3 normal)
        {
            normal = default;
            double share = 1.0 / sums.Count;
            var mean = (double3)sums.Offset * share;
            var squares = (double3)sums.Squares * share - mean * mean;
            var mixed = (double3)sums.Mixed * share - new double3(mean.x * mean.y, mean.x * mean.z, mean.y * mean.z);
            double trace = math.csum(squares);
            if (!(trace > 0))
                return false;
            squares *= 1 / trace;
            mixed *= 1 / trace;
            // The characteristic polynomial is x^3 - x^2 + minors x - determinant.
            double minors = squares.x * squares.y + squares.x * squares.z + squares.y * squares.z - math.lengthsq(mixed);
            double determinant = squares.x * (squares.y * squares.z - mixed.z * mixed.z) -
                mixed.x * (mixed.x * squares.z - mixed.y * mixed.z) + mixed.y * (mixed.x * mixed.z - mixed.y * squares.y);
            double smallest = SmallestRoot(minors, determinant);
            // The other two add up to the rest.
            double rest = 1 - smallest, product = minors - smallest * rest;
            double middle = (rest - math.sqrt(math.max(0, rest * rest - 4 * product))) / 2;
            if (middle < MinShare || middle - smallest < MinDifference)
                return false;
            normal = (float3)Eigenvector(squares - smallest, mixed);
            return true;
        }

        /// <summary>Newton's method from 0, which is below all roots: it never steps over the first.</summary>
        static double SmallestRoot(double minors, double determinant)
        {
            double x = 0;
            for (int step = 0; step < MaxSteps; step++)
            {
                double slope = (3 * x - 2) * x + minors;
                if (slope <= 0)
                    break;
                double change = (((x - 1) * x + minors) * x - determinant) / slope;
                x -= change;
                // The next one would be about as small as the square of it.
                if (math.abs(change) < 1e-7)
                    break;
            }
            return math.max(0, x);
        }

        /// <summary>Of a matrix of rank 2, given its diagonal: across its rows. The longest product is the most exact.</summary>
        static double3 Eigenvector(double3 diagonal, double3 mixed)
        {
            var x = new double3(diagonal.x, mixed.x, mixed.y);
            var y = new double3(mixed.x, diagonal.y, mixed.z);
            var z = new double3(mixed.y, mixed.z, diagonal.z);
            var a = math.cross(x, y);
            var b = math.cross(x, z);
            var c = math.cross(y, z);
            double lengthA = math.lengthsq(a), lengthB = math.lengthsq(b), lengthC = math.lengthsq(c);
            return lengthA >= lengthB && lengthA >= lengthC ? a / math.sqrt(lengthA)
                : lengthB >= lengthC ? b / math.sqrt(lengthB) : c / math.sqrt(lengthC);
        }
    }
}
