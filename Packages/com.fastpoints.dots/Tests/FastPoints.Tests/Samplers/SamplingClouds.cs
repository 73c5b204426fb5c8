using System;
using System.Collections.Generic;
using FastPoints.Points;
using NUnit.Framework;

namespace FastPoints.Tests.Samplers
{
    /// <summary>Small clouds, seeded, that samplers are compared with their references on.</summary>
    static class SamplingClouds
    {
        public static Grid3[] Make(int count, Func<Unity.Mathematics.Random, int, (Grid3, Unity.Mathematics.Random)> make)
        {
            var random = new Unity.Mathematics.Random(99);
            var places = new Grid3[count];
            for (int i = 0; i < count; i++)
                (places[i], random) = make(random, i);
            return places;
        }

        public static Grid3[] Volume(int count, int side) => Make(count, (r, i) =>
            (new Grid3(r.NextInt(side), r.NextInt(side), r.NextInt(side)), r));

        public static Grid3[] Surface(int count, int side) => Make(count, (r, i) =>
        {
            int x = r.NextInt(side), y = r.NextInt(side);
            return (new Grid3(x, y, (long)(side * (0.5 + 0.2 * Math.Sin(9.0 * x / side) * Math.Cos(7.0 * y / side)))), r);
        });

        public static Grid3[] Lattice(int edge, int step)
        {
            var places = new List<Grid3>();
            for (int i = 0; i < edge * edge * edge; i++)
                places.Add(new Grid3(i % edge * step, i / edge % edge * step, i / edge / edge * step));
            return places.ToArray();
        }

        public static IEnumerable<TestCaseData> All()
        {
            yield return Case("volume", Volume(3000, 1 << 20));
            yield return Case("surface", Surface(3000, 1 << 16));
            yield return Case("line", Make(2000, (r, i) => (new Grid3(i * 37, i * 37, i * 37), r)));
            yield return Case("lattice of one step", Lattice(14, 1));
            yield return Case("lattice of the spacing", Lattice(14, 64));
            yield return Case("all equal", Make(1000, (r, i) => (new Grid3(7, 8, 9), r)));
            yield return Case("density of a million to one", Make(3000, (r, i) => (i % 1000 == 0
                ? new Grid3(r.NextInt(1 << 30), r.NextInt(1 << 30), r.NextInt(1 << 30))
                : new Grid3((1 << 29) + r.NextInt(1000), 77 + r.NextInt(1000), 5 + r.NextInt(1000)), r)));
            yield return Case("four steps wide", Make(2000, (r, i) => (new Grid3(r.NextInt(4), r.NextInt(4), r.NextInt(4)), r)));
            yield return Case("as wide as integers", Make(2000, (r, i) =>
                (new Grid3(r.NextInt(int.MaxValue), r.NextInt(int.MaxValue), i % 2 * (long)int.MaxValue), r)));
        }

        /// <summary>{m} stands for the method's name.</summary>
        static TestCaseData Case(string name, Grid3[] places) => new TestCaseData((object)places).SetName("{m}(" + name + ")");
    }
}
