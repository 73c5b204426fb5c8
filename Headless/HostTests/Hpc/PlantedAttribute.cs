using System;

namespace FastPoints.HostTests.Hpc
{
    /// <summary>A job or class of entry methods that the verifier must report with that text, or, without one, let
    /// pass.</summary>
    [AttributeUsage(AttributeTargets.Struct | AttributeTargets.Class)]
    internal sealed class PlantedAttribute : Attribute
    {
        public PlantedAttribute(string reported = null)
        {
            Reported = reported;
        }

        public string Reported { get; }
    }
}
