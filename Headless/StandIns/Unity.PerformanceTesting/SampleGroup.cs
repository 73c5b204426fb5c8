namespace Unity.PerformanceTesting
{
    public class SampleGroup
    {
        public string Name;
        public SampleUnit Unit;
        public bool IncreaseIsBetter;
        public List<double> Samples = new List<double>();

        public SampleGroup(string name, SampleUnit unit = SampleUnit.Millisecond, bool increaseIsBetter = false)
        {
            Name = name;
            Unit = unit;
            IncreaseIsBetter = increaseIsBetter;
        }
    }
}
