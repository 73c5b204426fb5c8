namespace Unity.PerformanceTesting;

public class SampleGroup(string name, SampleUnit unit = SampleUnit.Millisecond, bool increaseIsBetter = false)
{
    public string Name = name;
    public SampleUnit Unit = unit;
    public bool IncreaseIsBetter = increaseIsBetter;
    public List<double> Samples = new List<double>();
}
