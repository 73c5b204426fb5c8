using System.Linq;
using FastPoints.Evaluation;
using Unity.Mathematics;

namespace FastPoints.Tests.Surface
{
    /// <summary>A sphere under gravity among triangles that hold from the side they face alone, as a physics engine has them:
    /// in each step it moves, and is pushed out of what it touches.</summary>
    internal static class FallingSphere
    {
        const double StepSeconds = 1.0 / 60, Gravity = 9.81;
        const int Steps = 24, Pushes = 3;

        /// <summary>As if from half a metre above.</summary>
        /// <returns>Where its centre is in the end.</returns>
        public static double3 Drop(TriangleGrid grid, double3 centre, double radius)
        {
            var speed = new double3(0, 0, -3);
            for (int step = 0; step < Steps; step++)
            {
                speed.z -= Gravity * StepSeconds;
                centre += speed * StepSeconds;
                for (int push = 0; push < Pushes && TryPush(grid, ref centre, radius, out var normal); push++)
                {
                    // It does not bounce, and does not slide: what is under it would not be tried.
                    double into = math.dot(speed, normal);
                    speed = into < 0 ? 0.5 * (speed - into * normal) : speed;
                }
            }
            return centre;
        }

        /// <summary>Out of the deepest one.</summary>
        static bool TryPush(TriangleGrid grid, ref double3 centre, double radius, out double3 normal)
        {
            double deepest = 0;
            normal = default;
            foreach (int t in grid.TrianglesIn(centre - radius, centre + radius).Distinct())
            {
                var (a, b, c) = grid.CornersOf(t);
                var across = math.cross(b - a, c - a);
                if (math.dot(centre - a, across) <= 0)
                    continue;
                var way = centre - TriangleGrid.Nearest(centre, a, b, c);
                double distance = math.length(way);
                if (radius - distance <= deepest || distance == 0)
                    continue;
                deepest = radius - distance;
                normal = way / distance;
            }
            centre += normal * deepest;
            return deepest > 1e-6;
        }
    }
}
