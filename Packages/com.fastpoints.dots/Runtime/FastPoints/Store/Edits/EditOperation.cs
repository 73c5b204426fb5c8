using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace FastPoints.Store
{
    internal enum EditAction
    {
        // Not shown or picked any more; exports have it.
        Hide,
        Delete,
        Classify,
        Color,
    }

    // One change of a cloud, to all points that lie in any of the boxes, in any of the balls and in the prism, as far as there
    // are such, and for which the conditions hold. Conditions see what earlier operations made. Exact: nothing depends on how
    // points are stored. It converts from and to text, without I/O.
    internal sealed class EditOperation
    {
        public const long MaxCoordinate = 1L << 61; // Of shapes, in grid steps; positions have up to 60 bits.

        const long MaxAxis = 1L << 31;

        static readonly string[] s_members = { "do", "pointsChanged", "value", "boxes", "balls", "prism", "pyramid", "where" };
        static readonly string[] s_actions = { "hide", "delete", "classify", "colour" };

        public EditAction Action;
        public byte[] Value = new byte[0]; // The class, or red, green and blue in eight bits, whatever the cloud has.

        public readonly List<EditShape> Boxes = new List<EditShape>();
        public readonly List<EditShape> Balls = new List<EditShape>();
        public EditPrism Prism = EditPrism.Empty; // Its bounds grow with the rings.

        // Closed: u and v of each vertex. Those of one polygon follow one another.
        public readonly List<(int Polygon, long[] Vertices)> Rings = new List<(int, long[])>();

        public readonly List<FilterExpression> Conditions = new List<FilterExpression>();

        public long PointsChanged;
        public ulong? CloudId; // Of the conversion that positions are of, where somebody knows. Not in the text.

        public string Name => s_actions[(int)Action];

        // Those that Value is for.
        public string[] ChangedAttributes => Action == EditAction.Classify ? new[] { AttributeNames.Classification }
            : Action == EditAction.Color ? new[] { AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue }
            : Array.Empty<string>();

        public void AddRing(int polygon, long[] vertices)
        {
            Rings.Add((polygon, vertices));
            for (int i = 0; i + 1 < vertices.Length; i += 2)
                Prism.Include(vertices[i], vertices[i + 1]);
        }

        // What is seen inside of a polygon through positions: from an eye, whose w is 1, or against a direction, whose w is 0.
        // Returns what is wrong, or null. A pyramid is exact but for its eye, which lies on the nearest grid position, and its
        // corners' places: where U, V and W point only says on which plane it is drawn. A prism's axes are within 2^-30.
        public string SetLasso(in CloudGrid grid, double4 eye, IReadOnlyList<double3> corners)
        {
            bool isPyramid = eye.w != 0;
            double3 forward = default, step = grid.Step;
            foreach (var corner in corners)
                forward += isPyramid ? math.normalize(corner - eye.xyz) : -eye.xyz;
            forward = math.normalize(forward);
            if (corners.Count < 3 || !math.all(math.isfinite(forward)))
                return "wanted an eye and at least three corners before it";
            var right = math.normalize(math.cross(forward, math.abs(forward.z) < 0.9 ? new double3(0, 0, 1)
                : new double3(1, 0, 0)));
            double3 from = isPyramid ? eye.xyz : corners[0];
            Prism.Origin = EditShape.GridOf(math.round((from - grid.Origin) / step));
            (Prism.U, Prism.V) = (AxisOf(right * step, MaxAxis / 2), AxisOf(math.cross(right, forward) * step, MaxAxis / 2));
            double widest = 0;
            var places = new double3[corners.Count]; // u, v and depth.
            for (int i = 0; i < places.Length; i++)
            {
                var at = (corners[i] - (isPyramid ? from : grid.ToGeo(Prism.Origin))) / step;
                places[i] = new double3(Dot(at, Prism.U), Dot(at, Prism.V), math.dot(at, forward * step));
                widest = math.max(widest, math.cmax(math.abs(places[i].xy)) / places[i].z * math.cmax(math.abs(forward * step)));
            }
            // So that corners' places are as fine as they can be.
            Prism.W = isPyramid ? AxisOf(forward * step, math.clamp(widest * EditPrism.PlacesPerSlope * 4 / EditPrism.MaxPlace,
                256, MaxAxis / 2)) : default;
            var vertices = new long[2 * places.Length];
            for (int i = 0; i < places.Length; i++)
            {
                double depth = isPyramid ? Dot((corners[i] - from) / step, Prism.W) / EditPrism.PlacesPerSlope : 1;
                var place = places[i].xy / depth;
                if (!(depth > 0) || !(math.cmax(math.abs(place)) < (isPyramid ? EditPrism.MaxPlace : MaxCoordinate)))
                    return "a corner lies beside the eye or behind it, or too far away";
                (vertices[2 * i], vertices[2 * i + 1]) = ((long)math.round(place.x), (long)math.round(place.y));
            }
            AddRing(0, vertices);
            return null;
        }

        static Grid3 AxisOf(double3 direction, double length) =>
            EditShape.GridOf(math.round(direction * (length / math.cmax(math.abs(direction)))));

        static double Dot(double3 at, Grid3 axis) => at.x * axis.X + at.y * axis.Y + at.z * axis.Z;

        // Whether it may change points in a box, as far as its shapes say.
        public bool MayReach(in EditShape box) =>
            Reach(Boxes, box, EditReach.Some) && Reach(Balls, box, EditReach.Some) && MaySee(box);

        public bool MaySee(in EditShape box) => !Prism.IsUsed || Prism.TryProject(box, out _);

        // Whether any of the shapes holds as much of a box, if there are any.
        public static bool Reach(List<EditShape> shapes, in EditShape box, EditReach reach)
        {
            bool isReached = shapes.Count == 0;
            for (int i = 0; i < shapes.Count && !isReached; i++)
                isReached = shapes[i].ReachOf(box) >= reach;
            return isReached;
        }

        // What is wrong with it, or null.
        public string FindProblem()
        {
            foreach (var box in Boxes)
                if (!IsWithin(box.A, MaxCoordinate) || !IsWithin(box.B, MaxCoordinate))
                    return "a box is too far away";
            foreach (var ball in Balls)
            {
                long min = ball.IsRound ? 0 : 1, max = ball.IsRound ? MaxCoordinate : EditShape.MaxUnequalRadius;
                var low = new Grid3(min, min, min);
                if (!IsWithin(ball.A, MaxCoordinate) || !IsWithin(ball.B, max) || Grid3.Min(ball.B, low) != low)
                    return "a ball is too far away, or its radius is: wanted " + NumberText.Of(min) + " to " +
                        NumberText.Of(max) + " steps, got " + ball.B;
            }
            long farthest = Prism.IsPyramid ? EditPrism.MaxPlace : MaxCoordinate;
            return !Prism.IsUsed || IsWithin(Prism.Origin, MaxCoordinate) && IsWithin(Prism.U, MaxAxis) &&
                IsWithin(Prism.V, MaxAxis) && IsWithin(Prism.W, MaxAxis) && IsWithin(new Grid3(Prism.MaxV, 0, 0), farthest) &&
                IsWithin(new Grid3(Prism.MinU, Prism.MinV, Prism.MaxU), farthest) ? null
                : "a polygon is too far away or too large";
        }

        static bool IsWithin(Grid3 position, long max)
        {
            Grid3 high = new Grid3(max, max, max), low = default(Grid3) - high;
            return Grid3.Max(position, high) == high && Grid3.Min(position, low) == low;
        }

        public string ToJson()
        {
            var json = new JsonWriter().BeginObject().Add("do", Name).Add("pointsChanged", PointsChanged).BeginArray("value");
            foreach (byte value in Value)
                json.Add(null, (long)value);
            Add(json.EndArray(), "boxes", Boxes);
            Add(json, "balls", Balls);
            if (Prism.IsUsed)
            {
                // Two names, so that versions that know no pyramids do not take one for a prism.
                json.BeginObject(Prism.IsPyramid ? "pyramid" : "prism");
                Add(Add(Add(json, "origin", Prism.Origin), "u", Prism.U), "v", Prism.V);
                (Prism.IsPyramid ? Add(json, "w", Prism.W) : json).BeginArray("rings");
                foreach (var (polygon, vertices) in Rings)
                {
                    json.BeginObject().Add("polygon", (long)polygon).BeginArray("at");
                    foreach (long at in vertices)
                        json.Add(null, at);
                    json.EndArray().EndObject();
                }
                json.EndArray().EndObject();
            }
            json.BeginArray("where");
            foreach (var condition in Conditions)
                json.Add(null, condition.Text);
            return json.EndArray().EndObject().ToString();
        }

        static void Add(JsonWriter json, string name, List<EditShape> shapes)
        {
            json.BeginArray(name);
            foreach (var shape in shapes)
                Add(Add(json.BeginObject(), "a", shape.A), "b", shape.B).EndObject();
            json.EndArray();
        }

        static JsonWriter Add(JsonWriter json, string name, Grid3 value) => json.Add(name, value.X, value.Y, value.Z);

        public static EditOperation FromJson(string text, string path)
        {
            var json = JsonMembers.Parse(text, path);
            // It cannot be left out.
            foreach (string name in json.Names)
                if (Array.IndexOf(s_members, name) < 0)
                    throw new PointCloudException(FailureCode.Unsupported, path, -1, "\"" + name + "\" is of a later version");
            int action = Array.IndexOf(s_actions, json.Text("do"));
            if (action < 0)
                throw json.Wanted("do", string.Join(", ", s_actions));
            var operation = new EditOperation { Action = (EditAction)action, PointsChanged = json.NonNegative("pointsChanged") };
            operation.Value = Array.ConvertAll(json.Longs("value", operation.ChangedAttributes.Length),
                value => value == (byte)value ? (byte)value : throw json.Wanted("value", "numbers from 0 to 255"));
            foreach (var box in json.Objects("boxes"))
                operation.Boxes.Add(new EditShape { A = GridOf(box, "a"), B = GridOf(box, "b") });
            foreach (var ball in json.Objects("balls"))
                operation.Balls.Add(new EditShape { A = GridOf(ball, "a"), B = GridOf(ball, "b"), IsBall = true });
            bool isPyramid = json.Has("pyramid");
            if (isPyramid && json.Has("prism"))
                throw json.Wanted("prism", "no pyramid besides");
            if (isPyramid || json.Has("prism"))
                operation.ReadPrism(json.Object(isPyramid ? "pyramid" : "prism"), isPyramid);
            try
            {
                operation.Conditions.AddRange(json.Texts("where").ConvertAll(FilterExpression.Parse));
            }
            catch (FormatException e)
            {
                throw json.Failure("where", e.Message, e);
            }
            string problem = operation.FindProblem();
            return problem == null ? operation : throw new PointCloudException(FailureCode.BadInput, path, -1, problem);
        }

        void ReadPrism(JsonMembers prism, bool isPyramid)
        {
            (Prism.Origin, Prism.U, Prism.V) = (GridOf(prism, "origin"), GridOf(prism, "u"), GridOf(prism, "v"));
            Prism.W = isPyramid ? GridOf(prism, "w") : default;
            foreach (var ring in prism.Objects("rings"))
                AddRing(ring.Int("polygon"), ring.Longs("at"));
            // Without one it would mean all points.
            if (!Prism.IsUsed || Prism.IsPyramid != isPyramid || Rings.Exists(ring => ring.Vertices.Length % 2 != 0))
                throw prism.Wanted("rings", "u and v of each vertex");
        }

        static Grid3 GridOf(JsonMembers json, string name)
        {
            long[] steps = json.Longs(name, 3);
            return new Grid3(steps[0], steps[1], steps[2]);
        }
    }
}
