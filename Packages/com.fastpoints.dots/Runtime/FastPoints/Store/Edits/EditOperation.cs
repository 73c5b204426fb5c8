using System;
using System.Collections.Generic;

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
        // Of shapes, in grid steps; positions have up to 60 bits.
        public const long MaxCoordinate = 1L << 61;

        // Of the components of a prism's axes.
        const long MaxAxis = 1L << 31;

        static readonly string[] s_members =
        {
            "do", "pointsChanged", "class", "colour", "boxes", "balls", "prism", "where",
        };

        static readonly string[] s_actions = { "hide", "delete", "classify", "colour" };

        public EditAction Action;
        public byte Class;

        // In eight bits, whatever the cloud has.
        public byte Red;
        public byte Green;
        public byte Blue;

        public readonly List<EditBox> Boxes = new List<EditBox>();
        public readonly List<EditBall> Balls = new List<EditBall>();

        // Its bounds grow with the rings.
        public EditPrism Prism = EditPrism.Empty;

        // Closed: u and v of each vertex. Those of one polygon follow one another.
        public readonly List<(int Polygon, long[] Vertices)> Rings = new List<(int, long[])>();

        public readonly List<FilterExpression> Conditions = new List<FilterExpression>();

        // Counted when it was made.
        public long PointsChanged;

        public string Name => s_actions[(int)Action];

        public IEnumerable<string> ChangedAttributes => Action == EditAction.Classify
            ? new[] { AttributeNames.Classification }
            : Action == EditAction.Color ? new[] { AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue }
            : Array.Empty<string>();

        public void AddRing(int polygon, long[] vertices)
        {
            Rings.Add((polygon, vertices));
            for (int i = 0; i + 1 < vertices.Length; i += 2)
                Prism.Include(vertices[i], vertices[i + 1]);
        }

        // Whether it may change points in a box, as far as its shapes say.
        public bool MayReach(in EditBox box)
        {
            bool isReached = Boxes.Count == 0;
            foreach (var own in Boxes)
                isReached |= own.ReachOf(box) != EditReach.None;
            if (!isReached || Prism.IsUsed && !Prism.TryProject(box, out _))
                return false;
            isReached = Balls.Count == 0;
            foreach (var ball in Balls)
                isReached |= ball.ReachOf(box) != EditReach.None;
            return isReached;
        }

        // What is wrong with it, or null.
        public string FindProblem()
        {
            foreach (var box in Boxes)
                if (!IsWithin(box.Min, MaxCoordinate) || !IsWithin(box.Max, MaxCoordinate))
                    return "a box is too far away";
            foreach (var ball in Balls)
            {
                if (!IsWithin(ball.Center, MaxCoordinate) || !IsWithin(ball.Radius, MaxCoordinate) ||
                    Grid3.Min(ball.Radius, default) != default)
                    return "a ball is too far away or too large";
                if (!ball.IsRound && (Grid3.Min(ball.Radius, new Grid3(1, 1, 1)) != new Grid3(1, 1, 1) ||
                    !IsWithin(ball.Radius, EditBall.MaxUnequalRadius)))
                    return "a ball on a grid whose steps differ: wanted radii from 1 to " +
                        NumberText.Of(EditBall.MaxUnequalRadius) + " steps, got " + ball.Radius;
            }
            if (Prism.IsUsed && (!IsWithin(Prism.Origin, MaxCoordinate) || !IsWithin(Prism.U, MaxAxis) ||
                !IsWithin(Prism.V, MaxAxis) || !IsWithin(new Grid3(Prism.MinU, Prism.MinV, 0), MaxCoordinate) ||
                !IsWithin(new Grid3(Prism.MaxU, Prism.MaxV, 0), MaxCoordinate)))
                return "a polygon is too far away or too large";
            return null;
        }

        static bool IsWithin(Grid3 position, long max) => position.X >= -max && position.X <= max && position.Y >= -max &&
            position.Y <= max && position.Z >= -max && position.Z <= max;

        public string ToJson()
        {
            var json = new JsonWriter().BeginObject().Add("do", Name).Add("pointsChanged", PointsChanged);
            if (Action == EditAction.Classify)
                json.Add("class", (long)Class);
            if (Action == EditAction.Color)
                json.Add("colour", (long)Red, (long)Green, (long)Blue);
            if (Boxes.Count > 0)
            {
                json.BeginArray("boxes");
                foreach (var box in Boxes)
                    Add(Add(json.BeginObject(), "min", box.Min), "max", box.Max).EndObject();
                json.EndArray();
            }
            if (Balls.Count > 0)
            {
                json.BeginArray("balls");
                foreach (var ball in Balls)
                    Add(Add(json.BeginObject(), "centre", ball.Center), "radius", ball.Radius).EndObject();
                json.EndArray();
            }
            if (Prism.IsUsed)
                AddPrism(json);
            if (Conditions.Count > 0)
            {
                json.BeginArray("where");
                foreach (var condition in Conditions)
                    json.Add(null, condition.Text);
                json.EndArray();
            }
            return json.EndObject().ToString();
        }

        void AddPrism(JsonWriter json)
        {
            json.BeginObject("prism");
            Add(Add(Add(json, "origin", Prism.Origin), "u", Prism.U), "v", Prism.V).BeginArray("rings");
            foreach (var (polygon, vertices) in Rings)
            {
                json.BeginObject().Add("polygon", (long)polygon).BeginArray("at");
                foreach (long at in vertices)
                    json.Add(null, at);
                json.EndArray().EndObject();
            }
            json.EndArray().EndObject();
        }

        static JsonWriter Add(JsonWriter json, string name, Grid3 value) => json.Add(name, value.X, value.Y, value.Z);

        // Members that it does not know are those of a later version, which it cannot leave out.
        public static EditOperation FromJson(string text, string path)
        {
            var json = JsonMembers.Parse(text, path);
            foreach (string name in json.Names)
                if (Array.IndexOf(s_members, name) < 0)
                    throw new PointCloudException(FailureCode.Unsupported, path, -1, "\"" + name + "\" is of a later version");
            int action = Array.IndexOf(s_actions, json.Text("do"));
            if (action < 0)
                throw json.Bad("do", string.Join(", ", s_actions));
            var operation = new EditOperation
            {
                Action = (EditAction)action,
                PointsChanged = json.Count("pointsChanged"),
            };
            if (operation.Action == EditAction.Classify)
                operation.Class = (byte)json.Count("class", byte.MaxValue);
            if (operation.Action == EditAction.Color)
            {
                long[] color = json.Longs("colour", 3);
                (operation.Red, operation.Green, operation.Blue) = ((byte)color[0], (byte)color[1], (byte)color[2]);
            }
            foreach (var box in json.Has("boxes") ? json.Objects("boxes") : new List<JsonMembers>())
                operation.Boxes.Add(new EditBox { Min = GridOf(box, "min"), Max = GridOf(box, "max") });
            foreach (var ball in json.Has("balls") ? json.Objects("balls") : new List<JsonMembers>())
                operation.Balls.Add(new EditBall { Center = GridOf(ball, "centre"), Radius = GridOf(ball, "radius") });
            if (json.Has("prism"))
                operation.ReadPrism(json.Object("prism"));
            foreach (string condition in json.Has("where") ? json.Texts("where") : new List<string>())
                operation.Conditions.Add(ReadCondition(condition, json));
            string problem = operation.FindProblem();
            return problem == null ? operation : throw new PointCloudException(FailureCode.BadInput, path, -1, problem);
        }

        void ReadPrism(JsonMembers prism)
        {
            (Prism.Origin, Prism.U, Prism.V) = (GridOf(prism, "origin"), GridOf(prism, "u"), GridOf(prism, "v"));
            foreach (var ring in prism.Objects("rings"))
            {
                long[] vertices = ring.Longs("at");
                if (vertices.Length % 2 != 0)
                    throw ring.Bad("at", "u and v of each vertex");
                AddRing(ring.Int("polygon"), vertices);
            }
            // Without one it would mean all points.
            if (!Prism.IsUsed)
                throw prism.Bad("rings", "vertices");
        }

        static FilterExpression ReadCondition(string text, JsonMembers json)
        {
            try
            {
                return FilterExpression.Parse(text);
            }
            catch (FormatException e)
            {
                throw json.Wrong("where", e.Message, e);
            }
        }

        static Grid3 GridOf(JsonMembers json, string name)
        {
            long[] steps = json.Longs(name, 3);
            return new Grid3(steps[0], steps[1], steps[2]);
        }
    }
}
