%%%
  VERSION:1
  LANGUAGE:ENGLISH
%%%
MODULE MainModule
  PERS tooldata tGrip:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];
  PERS wobjdata wTable:=[FALSE,TRUE,"",[[500,0,0],[1,0,0,0]],[[0,100,0],[0.707106781,0,0,0.707106781]]];
  CONST robtarget pHome:=[[100,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E+09]];
  LOCAL CONST robtarget pList{2}:=[[[0,0,100],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],
                                   [[50,0,100],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]];
  CONST jointtarget jRest:=[[0,0,0,0,90,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  VAR num n;
  VAR robtarget pick;
  PROC main()
    AccSet 80,80;
    MoveAbsJ jRest\NoEOffs,v1000,fine,tGrip;   ! at rest
    MoveJ pHome,v500,z10,tGrip;
    FOR i FROM 1 TO Dim(pList,1) DO
      MoveL Offs(pList{i},0,0,10*i),v100,z5,tGrip\WObj:=wTable;
    ENDFOR
    pick:=pList{1};
    pick.trans.z:=pick.trans.z-25;
    MoveL RelTool(pick,0,0,5\Rz:=90),v50,fine,tGrip\WObj:=wTable;
    SetDO doGrip,1;
    WaitTime 0.3;
    n:=0;
    WHILE n<2 DO
      Incr n;
      up 10*n;
    ENDWHILE
    IF n=2 MoveJ pHome,v500,fine,tGrip;
    TEST n
    CASE 1,5:
      Stop;
    CASE 2:
      MoveL Offs(pHome,1,2,3),v500,fine,tGrip;
    DEFAULT:
      Stop;
    ENDTEST
  ERROR
    RETRY;
  ENDPROC
  PROC up(num h)
    MoveL Offs(pick,0,0,h),v50,fine,tGrip\WObj:=wTable;
  ENDPROC
ENDMODULE
