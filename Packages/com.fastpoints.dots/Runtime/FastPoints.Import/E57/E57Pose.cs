using System;
using FastPoints.Core;
using Unity.Mathematics;

namespace FastPoints.E57
{
    // From the scanner's coordinates to the file's (ASTM E2807, 8.4.4).
    struct E57Pose
    {
        // The scanner's axes in the file's coordinates.
        public double3 AxisX;
        public double3 AxisY;
        public double3 AxisZ;
        public double3 Translation;

        // There is no rotation.
        public bool IsShift;

        public static E57Pose Identity => new E57Pose
        {
            AxisX = new double3(1, 0, 0),
            AxisY = new double3(0, 1, 0),
            AxisZ = new double3(0, 0, 1),
            IsShift = true,
        };

        public bool IsIdentity => IsShift && math.all(Translation == new double3(0, 0, 0));

        // problem: what was assumed instead, if the numbers are not a valid pose.
        public static E57Pose Read(E57Node node, out string problem)
        {
            var pose = Identity;
            problem = null;
            var shift = node?.Child("translation");
            if (shift != null)
            {
                pose.Translation = new double3(shift.NumberOf("x"), shift.NumberOf("y"), shift.NumberOf("z"));
                if (!math.all(math.isfinite(pose.Translation)))
                {
                    pose.Translation = new double3(0, 0, 0);
                    problem = "the pose's translation is no three numbers: 0, 0, 0 is assumed";
                }
            }
            var turn = node?.Child("rotation");
            if (turn == null)
                return pose;
            double w = turn.NumberOf("w"), x = turn.NumberOf("x"), y = turn.NumberOf("y"), z = turn.NumberOf("z");
            double lengthSq = w * w + x * x + y * y + z * z;
            if (!(lengthSq > 1e-6) || double.IsInfinity(lengthSq))
            {
                problem = "the pose's rotation is no quaternion: no rotation is assumed";
                return pose;
            }
            if (Math.Abs(lengthSq - 1) > 1e-3)
                problem = "the pose's quaternion has a length of " + NumberText.Of(Math.Sqrt(lengthSq)) + ": it is scaled to 1";
            if (x == 0 && y == 0 && z == 0)
                return pose;
            double s = 2 / lengthSq;
            pose.IsShift = false;
            pose.AxisX = new double3(1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y));
            pose.AxisY = new double3(s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x));
            pose.AxisZ = new double3(s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y));
            return pose;
        }
    }
}
