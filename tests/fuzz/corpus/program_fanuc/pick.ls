/PROG  PICK
/ATTR
OWNER       = MNEDITOR;
COMMENT     = "";
PROG_SIZE   = 500;
DEFAULT_GROUP   = 1,*,*,*,*;
CONTROL_CODE    = 00000000 00000000;
/APPL
/MN
   1:  UFRAME_NUM=0 ;
   2:  UTOOL_NUM=1 ;
   3:J P[1:home] 20% FINE    ;
   4:  ! a remark ;
   5:L P[2] 250mm/sec CNT50    ;
   6:L P[3] 60cm/min FINE ACC80    ;
   7:  WAIT    .50(sec) ;
   8:  R[1]=0    ;
   9:  LBL[1] ;
  10:L P[2] 100mm/sec FINE    ;
  11:  R[1]=R[1]+1    ;
  12:  IF R[1]<2,JMP LBL[1] ;
  13:  DO[1]=ON ;
  14:C P[3]
    :  P[4] 100mm/sec FINE    ;
  15:  CALL GRIP(1) ;
/POS
P[1:"home"]{
   GP1:
    UF : 0, UT : 1,     CONFIG : 'N U T, 0, 0, 0',
    X =   100.000  mm,  Y =     0.000  mm,  Z =   500.000  mm,
    W =   180.000 deg,  P =     0.000 deg,  R =     0.000 deg
};
P[2]{
   GP1:
    UF : 0, UT : 1,     CONFIG : 'F D B, 0, 0, -1',
    X =   200.000  mm,  Y =     0.000  mm,  Z =   500.000  mm,
    W =   180.000 deg,  P =     0.000 deg,  R =    90.000 deg,
    E1=   10.000  mm
   GP2:
    UF : 0, UT : 1,
    J1=     5.000 deg
};
P[3]{
   GP1:
    UF : 0, UT : 1,     CONFIG : 'N U T, 0, 0, 0',
    X =   250.000  mm,  Y =    50.000  mm,  Z =   500.000  mm,
    W =   180.000 deg,  P =     0.000 deg,  R =    90.000 deg
};
P[4]{
   GP1:
    UF : 0, UT : 1,     CONFIG : 'N U T, 0, 0, 0',
    X =   300.000  mm,  Y =     0.000  mm,  Z =   500.000  mm,
    W =   180.000 deg,  P =     0.000 deg,  R =    90.000 deg
};
/END
